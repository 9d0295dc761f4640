// Scalars for tests of the C templates: jets of any number, and classes with operators of many types.
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <type_traits>
#include <vector>

// Number with its derivatives by N variables, like ceres::Jet, also of jets; conversion of the value is explicit.
template <int N, class T = double> struct Jet {
    typedef T Scalar;
    T a, v[N];
    Jet() : a(), v() {}
    explicit Jet(const T &number) : a(number), v() {}
    Jet(const T &number, int k) : a(number), v() { v[k] = T(1); }
};
template <int N, class T> Jet<N, T> chain(const T &a, const T &by_f, const Jet<N, T> &f, const T &by_g, const Jet<N, T> &g)
{
    Jet<N, T> made(a);
    for (int i = 0; i < N; ++i) made.v[i] = by_f * f.v[i] + by_g * g.v[i];
    return made;
}
#define JET template <int N, class T>
#define J const Jet<N, T> &
JET Jet<N, T> operator+(J f, J g) { return chain(f.a + g.a, T(1.0), f, T(1.0), g); }
JET Jet<N, T> operator-(J f, J g) { return chain(f.a - g.a, T(1.0), f, T(-1.0), g); }
JET Jet<N, T> operator-(J f) { return chain(-f.a, T(-1.0), f, T(0.0), f); }
JET Jet<N, T> operator*(J f, J g) { return chain(f.a * g.a, g.a, f, f.a, g); }
JET Jet<N, T> operator/(J f, J g) { return chain(f.a / g.a, T(1.0) / g.a, f, -f.a / (g.a * g.a), g); }
JET bool operator<(J f, J g) { return f.a < g.a; }
JET bool operator==(J f, J g) { return f.a == g.a; }
JET Jet<N, T> abs(J f) { return f.a < T(0.0) ? -f : f; }
JET Jet<N, T> sqrt(J f) { using std::sqrt; return chain(sqrt(f.a), T(0.5) / sqrt(f.a), f, T(0.0), f); }
JET Jet<N, T> tan(J f) { using std::tan; return chain(tan(f.a), T(1.0) + tan(f.a) * tan(f.a), f, T(0.0), f); }
JET Jet<N, T> expm1(J f) { using std::expm1; return chain(expm1(f.a), T(1.0) + expm1(f.a), f, T(0.0), f); }
JET Jet<N, T> log1p(J f) { using std::log1p; return chain(log1p(f.a), T(1.0) / (T(1.0) + f.a), f, T(0.0), f); }
JET Jet<N, T> atan2(J g, J f)
{
    using std::atan2;
    const T square = f.a * f.a + g.a * g.a;
    return chain(atan2(g.a, f.a), f.a / square, g, -g.a / square, f);
}
#undef J

// Number with operators for every arithmetic type, and of nothing else.
struct Mixed {
    double a;
    Mixed(double number = 0) : a(number) {}
};
#define FUNCTIONS(Given, Made, value) \
    inline Made abs(const Given &x) { return Made(std::fabs(x.value)); } \
    inline Made sqrt(const Given &x) { return Made(std::sqrt(x.value)); } \
    inline Made tan(const Given &x) { return Made(std::tan(x.value)); } \
    inline Made expm1(const Given &x) { return Made(std::expm1(x.value)); } \
    inline Made log1p(const Given &x) { return Made(std::log1p(x.value)); } \
    inline Made atan2(const Given &y, const Given &x) { return Made(std::atan2(y.value, x.value)); }
#define MIXED(operation, Result) \
    inline Result operator operation(const Mixed &f, const Mixed &g) { return f.a operation g.a; } \
    template <class A> typename std::enable_if<std::is_arithmetic<A>::value, Result>::type \
    operator operation(A f, const Mixed &g) { return (double)f operation g.a; } \
    template <class A> typename std::enable_if<std::is_arithmetic<A>::value, Result>::type \
    operator operation(const Mixed &f, A g) { return f.a operation (double)g; }
MIXED(+, Mixed) MIXED(-, Mixed) MIXED(*, Mixed) MIXED(/, Mixed) MIXED(<, bool) MIXED(==, bool)
inline Mixed operator-(const Mixed &f) { return -f.a; }
FUNCTIONS(Mixed, Mixed, a)

// Number whose operators make expressions, which refer to their operands and differ in type.
template <class Self> struct Term {
    const Self &self() const { return static_cast<const Self &>(*this); }
};
struct Lazy : Term<Lazy> {
    double a;
    Lazy() : a(0) {}
    explicit Lazy(double number) : a(number) {}
    template <class E> Lazy(const Term<E> &e) : a(e.self().value()) {}
    double value() const { return a; }
};
struct Result : Term<Result> {
    double made;
    explicit Result(double number) : made(number) {}
    double value() const { return made; }
};
struct Truth {
    bool holds;
    explicit operator bool() const { return holds; }
};
#define LAZY(operation, Name) \
    template <class F, class G> struct Name : Term<Name<F, G> > { \
        const F &f; \
        const G &g; \
        Name(const F &f_, const G &g_) : f(f_), g(g_) {} \
        double value() const { return f.value() operation g.value(); } \
    }; \
    template <class F, class G> Name<F, G> operator operation(const Term<F> &f, const Term<G> &g) \
    { return Name<F, G>(f.self(), g.self()); }
LAZY(+, Sum) LAZY(-, Difference) LAZY(*, Product) LAZY(/, Quotient)
template <class F> struct Negative : Term<Negative<F> > {
    const F &f;
    explicit Negative(const F &f_) : f(f_) {}
    double value() const { return -f.value(); }
};
template <class F> Negative<F> operator-(const Term<F> &f) { return Negative<F>(f.self()); }
inline Truth operator<(const Lazy &f, const Lazy &g) { return Truth{f.a < g.a}; }
inline Truth operator==(const Lazy &f, const Lazy &g) { return Truth{f.a == g.a}; }
FUNCTIONS(Lazy, Result, a)
