//
// Shared code of the differential tests of kernels. The error of a part of a result (real part, dual part) is the norm
// of its difference from the exact part, in units of the machine epsilon and of a scale. The scale is the larger of the
// norm of the part and its change when the arguments change by their own size. The error includes the rounding of the
// expected numbers to doubles.
#ifndef DUALCAY_DIFFERENTIAL_H
#define DUALCAY_DIFFERENTIAL_H

#include "dualcay.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#define DUALCAY_EPSILON (sizeof(dualcay_real) == sizeof(float) ? (double)FLT_EPSILON : DBL_EPSILON)

static int differential_calls = 0;
static int differential_failures = 0;

static void differential_load(const double *given, int size, dualcay_real *at, size_t by)
{
    for (int i = 0; i < size; ++i) {
        at[(size_t)i * by] = (dualcay_real)given[i];
    }
}

// Largest error of the parts of a result; part_of[i] is the part of component i.
static double differential_error(
    const double *expected, const double *scales, const int *part_of, int size, const dualcay_real *at, size_t by)
{
    double worst = 0;
    for (int i = 0; i < size; ++i) {
        double square = 0;
        for (int j = 0; j < size; ++j) {
            if (part_of[j] == part_of[i]) {
                const double difference = (double)at[(size_t)j * by] - expected[j];
                square += difference * difference;
            }
        }
        const double off = sqrt(square);
        const double error = off <= 0 ? off : off / (scales[part_of[i]] * DUALCAY_EPSILON);  // a constant has no scale
        if (!(error <= worst)) {
            worst = error >= 0 ? error : HUGE_VAL;
        }
    }
    return worst;
}

static double differential_larger(double a, double b)
{
    return a < b ? b : a;
}

static void differential_report(const char *name, int calls, double error, double gate)
{
    const int failed = !(error <= gate);
    printf("%-52s %4d calls, largest error %7.2f eps%s\n", name, calls, error, failed ? "  FAILED" : "");
    differential_calls += calls;
    differential_failures += failed;
}

// Print the summary line of all calls, and return the exit status.
static int differential_summary(const char *name, double gate)
{
    const char *real = sizeof(dualcay_real) == sizeof(float) ? "float" : "double";
    if (differential_failures) {
        printf("%s, %s: %d functions FAILED (gate %.0f eps)\n", name, real, differential_failures, gate);
        return 1;
    }
    printf("%s, %s: %d calls agree (gate %.0f eps)\n", name, real, differential_calls, gate);
    return 0;
}

#endif
