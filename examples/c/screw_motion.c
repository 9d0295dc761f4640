// Motion of a body under a constant twist, by Rodrigues dual vectors v = tan(alpha/6) u; comparison with the exact one.
//
// The classical Runge-Kutta method integrates v' = dcay_inv(v) omega over one turn. After each step, v becomes the
// principal vector of the same pose, so the motion never meets the chart's singular angles. After one turn, the
// rotation is the identity and the displacement is 2 pi times pitch times axis.
#include <math.h>
#include <stdio.h>

#include <dualcay/cayley3.h>

enum { STEPS = 400 };

static void rate_at(const double v[6], const double k[6], double step, const double omega[6], double v_dot[6])
{
    double moved[6];
    for (int i = 0; i < 6; ++i) {
        moved[i] = v[i] + step * k[i];
    }
    dualcay_cayley3_rate(moved, omega, v_dot);
}

static void advance(double v[6], const double omega[6], double dt)
{
    static const double still[6] = {0};
    double k1[6], k2[6], k3[6], k4[6];
    rate_at(v, still, 0, omega, k1);
    rate_at(v, k1, dt / 2, omega, k2);
    rate_at(v, k2, dt / 2, omega, k3);
    rate_at(v, k3, dt, omega, k4);
    for (int i = 0; i < 6; ++i) {
        v[i] += dt / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
    dualcay_cayley3_principal(v, v);
}

int main(void)
{
    const double pi = 3.14159265358979323846;
    const double omega[6] = {0.6, 0.0, 0.8, 0.3, -0.2, 0.4}; // |angular velocity| = 1 rad/s
    const double pitch = omega[0] * omega[3] + omega[1] * omega[4] + omega[2] * omega[5];
    static double history[6 * STEPS], poses[16 * STEPS]; // components first, as loops over rows need
    double v[6] = {0};

    for (int step = 0; step < STEPS; ++step) {
        advance(v, omega, 2 * pi / STEPS);
        for (int i = 0; i < 6; ++i) {
            history[i * STEPS + step] = v[i];
        }
    }
    dualcay_cayley3_pose_rows(STEPS, history, STEPS, poses, STEPS);

    double worst = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 4; ++j) {
            const double found = poses[(4 * i + j) * STEPS + STEPS - 1];
            const double expected = j < 3 ? i == j : 2 * pi * pitch * omega[i];
            printf("%12.8f", found);
            worst = fmax(worst, fabs(found - expected));
        }
        printf("\n");
    }
    printf("largest difference from the exact motion: %.1e\n", worst);
    return worst < 1e-7 ? 0 : 1;
}
