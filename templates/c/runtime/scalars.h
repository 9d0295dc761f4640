// Arithmetic of integers with numbers of a class that lacks it; visible in this namespace only.
template <bool, class Type> struct dualcay_if {};
template <class Type> struct dualcay_if<true, Type> { typedef Type type; };
template <class Class> struct dualcay_is_class {
    template <class Any> static char test(int Any::*);
    template <class Any> static long test(...);
    static const bool value = sizeof(test<Class>(0)) == 1;
};
#define DUALCAY_WITH_INTEGERS(operation, Result) \
    template <class Class> DUALCAY_PLACE inline typename dualcay_if<dualcay_is_class<Class>::value, Result>::type \
    operator operation(int a, const Class &b) { return (Class)a operation b; } \
    template <class Class> DUALCAY_PLACE inline typename dualcay_if<dualcay_is_class<Class>::value, Result>::type \
    operator operation(const Class &a, int b) { return a operation (Class)b; }
DUALCAY_WITH_INTEGERS(+, Class)
DUALCAY_WITH_INTEGERS(-, Class)
DUALCAY_WITH_INTEGERS(*, Class)
DUALCAY_WITH_INTEGERS(/, Class)
DUALCAY_WITH_INTEGERS(<, bool)
DUALCAY_WITH_INTEGERS(==, bool)
#undef DUALCAY_WITH_INTEGERS

// Functions of the standard library, or of the namespace of a class.
#ifndef DUALCAY_FREESTANDING
template <class Real> DUALCAY_PLACE inline Real dualcay_abs(const Real &a) { using std::abs; return abs(a); }
template <class Real> DUALCAY_PLACE inline Real dualcay_sqrt(const Real &a) { using std::sqrt; return sqrt(a); }
template <class Real> DUALCAY_PLACE inline Real dualcay_tan(const Real &a) { using std::tan; return tan(a); }
template <class Real> DUALCAY_PLACE inline Real dualcay_atan2(const Real &y, const Real &x) { using std::atan2; return atan2(y, x); }
template <class Real> DUALCAY_PLACE inline Real dualcay_atan2(const Real &y, int x) { return dualcay_atan2(y, (Real)x); }
template <class Real> DUALCAY_PLACE inline Real dualcay_expm1(const Real &a) { using std::expm1; return expm1(a); }
template <class Real> DUALCAY_PLACE inline Real dualcay_log1p(const Real &a) { using std::log1p; return log1p(a); }
#endif
