// Compare dualcay_sqrt with sqrt for one real type; TYPE and SUFFIX are replaced by the test.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#define DUALCAY_FREESTANDING
#define DUALCAY_REAL TYPE
#include "dualcay.h"
int main(void)
{
    for (long i = 0; i < 400000; ++i) {
        double drawn;
        unsigned long long bits = ((unsigned long long)rand() << 42) ^ ((unsigned long long)rand() << 21) ^ rand();
        bits &= i % 4 ? 0x7fffffffffffffffULL : 0x000fffffffffffffULL;
        memcpy(&drawn, &bits, sizeof drawn);
        const TYPE x = (TYPE)(sizeof(TYPE) == 4 ? drawn * 1e-5 : drawn), near = sqrtSUFFIX(x);
        if (x < INFINITY && !(fabsSUFFIX(dualcay_sqrt(x) - near) <= nextafterSUFFIX(near, INFINITY) - near)) {
            printf("wrong at %La\n", (long double)x);
        }
    }
    const TYPE low = dualcay_sqrt(-1), none = dualcay_sqrt((TYPE)NAN);
    printf("%g %g %d %d\n", (double)dualcay_sqrt(0), (double)dualcay_sqrt((TYPE)INFINITY), low != low, none != none);
    return 0;
}
