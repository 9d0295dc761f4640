// Test of the C templates on jets, complex numbers and rationals; it prints the largest error of each law.
#include "scalars.h"

#include "cayley2.h"
#include "cayley3.h"
#include "rotation/cayley2.h"
#include "rotation/cayley3.h"

#ifdef WITH_GMP
#include <gmpxx.h>
#endif

using namespace dualcay;

static double larger(double a, double b) { return a < b || b != b ? b : a; }
static const double V[6] = {0.31, -0.22, 0.17, 1.5, -0.4, 0.9}, W[6] = {-0.3, 0.8, 0.5, 0.2, 1.1, -0.7};

#define LAWS(NAME) \
    /* by jets: derivative of twist = its Jacobian; derivative of from_pose(pose(v)) = identity */            \
    static double NAME##_jets() \
    { \
        Jet<6> v[6], w[6], twist[6], pose[16], back[6]; \
        double jacobian[36], error = 0; \
        for (int i = 0; i < 6; ++i) { v[i] = Jet<6>(V[i], i); w[i] = Jet<6>(W[i]); } \
        dualcay_##NAME##_twist(v, w, twist); \
        dualcay_##NAME##_twist_jacobian(V, W, jacobian); \
        dualcay_##NAME##_pose(v, pose); \
        dualcay_##NAME##_from_pose(pose, 0, back); \
        for (int i = 0; i < 6; ++i) \
            for (int k = 0; k < 6; ++k) { \
                error = larger(error, std::fabs(twist[i].v[k] - jacobian[6 * i + k])); \
                error = larger(error, std::fabs(back[i].v[k] - (i == k))); \
            } \
        return error; \
    } \
    /* likewise of rotations, and from_angle_axis(to_angle_axis(v)) */ \
    static double NAME##_rotations() \
    { \
        Jet<3> v[3], w[3], omega[3], angle[1], u[3], back[3]; \
        double jacobian[9], error = 0; \
        for (int i = 0; i < 3; ++i) { v[i] = Jet<3>(V[i], i); w[i] = Jet<3>(W[i]); } \
        dualcay_rotation_##NAME##_twist(v, w, omega); \
        dualcay_rotation_##NAME##_twist_jacobian(V, W, jacobian); \
        dualcay_rotation_##NAME##_to_angle_axis(v, angle, u); \
        dualcay_rotation_##NAME##_from_angle_axis(angle[0], u, back); \
        for (int i = 0; i < 3; ++i) \
            for (int k = 0; k < 3; ++k) { \
                error = larger(error, std::fabs(omega[i].v[k] - jacobian[3 * i + k])); \
                error = larger(error, std::fabs(back[i].v[k] - (i == k))); \
            } \
        return error; \
    } \
    /* by a complex step along w: derivative of the quaternion q = half of twist times q */               \
    static double NAME##_complex() \
    { \
        const double h = 1e-100; \
        std::complex<double> v[6], q[8]; \
        double twist[6], error = 0; \
        for (int i = 0; i < 6; ++i) v[i] = std::complex<double>(V[i], h * W[i]); \
        dualcay_##NAME##_quaternion(v, q); \
        dualcay_##NAME##_twist(V, W, twist); \
        for (int part = 0; part < 2; ++part) { \
            double expected = 0; \
            for (int k = 0; k < 3; ++k) { \
                expected -= twist[k] * q[4 * part + k + 1].real() / 2; \
                if (part) expected -= twist[3 + k] * q[k + 1].real() / 2; \
            } \
            error = larger(error, std::fabs(q[4 * part].imag() / h - expected)); \
        } \
        return error; \
    } \
    /* in exact numbers: rate(twist(w)) = w */  \
    template <class Number> static bool NAME##_inverts() \
    { \
        Number v[6], w[6], twist[6], back[6]; \
        bool same = true; \
        for (int i = 0; i < 6; ++i) { v[i] = Number(2 * i - 5) / Number(i + 7); w[i] = Number(3 * i - 4) / Number(11 - i); } \
        dualcay_##NAME##_twist(v, w, twist); \
        dualcay_##NAME##_rate(v, twist, back); \
        for (int i = 0; i < 6; ++i) same = same && back[i] == w[i]; \
        return same; \
    }

inline bool operator==(Residue a, Residue b) { return a.value == b.value; }

#ifdef WITH_GMP
// Without expression templates.
struct Rational {
    mpq_class value;
    Rational() {}
    explicit Rational(int number) : value(number) {}
    explicit Rational(double number) : value(number) {}
    explicit Rational(const mpq_class &number) : value(number) {}
};
inline Rational operator+(const Rational &a, const Rational &b) { return Rational(mpq_class(a.value + b.value)); }
inline Rational operator-(const Rational &a, const Rational &b) { return Rational(mpq_class(a.value - b.value)); }
inline Rational operator-(const Rational &a) { return Rational(mpq_class(-a.value)); }
inline Rational operator*(const Rational &a, const Rational &b) { return Rational(mpq_class(a.value * b.value)); }
inline Rational operator/(const Rational &a, const Rational &b) { return Rational(mpq_class(a.value / b.value)); }
inline bool operator==(const Rational &a, const Rational &b) { return a.value == b.value; }
#endif

LAWS(cayley2)
LAWS(cayley3)

#define REPORT(NAME) \
    std::printf(#NAME " jets %.17g\n" #NAME " complex %.17g\n", NAME##_jets(), NAME##_complex()); \
    std::printf(#NAME " rotations by jets %.17g\n", NAME##_rotations()); \
    std::printf(#NAME " residues %d\n", NAME##_inverts<Residue>());

int main()
{
    REPORT(cayley2)
    REPORT(cayley3)
#ifdef WITH_GMP
    std::printf("cayley2 rationals %d\ncayley3 rationals %d\n", cayley2_inverts<Rational>(), cayley3_inverts<Rational>());
#endif
    return 0;
}
