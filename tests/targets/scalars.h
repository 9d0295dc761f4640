// Scalars for tests of the C templates: residues, jets, and exact rationals.
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

__extension__ typedef unsigned __int128 Wide;

// Element of a prime field of at most 61 bits; it can be made from an integer or from a double multiple of 1/2.
struct Residue {
    static uint64_t prime;
    uint64_t value;
    Residue() : value(0) {}
    explicit Residue(int integer) : value(integer < 0 ? prime - (uint64_t)(-(int64_t)integer) : (uint64_t)integer) {}
    explicit Residue(double halves);
    static Residue of(uint64_t value) { Residue made; made.value = value; return made; }
};
uint64_t Residue::prime = 2305843009213693951u;
inline Residue operator+(Residue a, Residue b) { return Residue::of((a.value + b.value) % Residue::prime); }
inline Residue operator-(Residue a, Residue b)
{
    return Residue::of((a.value + Residue::prime - b.value) % Residue::prime);
}
inline Residue operator-(Residue a) { return Residue::of((Residue::prime - a.value) % Residue::prime); }
inline Residue operator*(Residue a, Residue b)
{
    return Residue::of((uint64_t)((Wide)a.value * b.value % Residue::prime));
}
inline Residue operator/(Residue a, Residue b)
{
    if (!b.value) { std::puts("division by zero"); std::exit(3); }
    Residue power = b;
    for (uint64_t e = Residue::prime - 2; e; e >>= 1) {
        if (e & 1) a = a * power;
        power = power * power;
    }
    return a;
}

inline Residue::Residue(double halves) { *this = Residue((int)(2 * halves)) / Residue(2); }

// Number with its derivatives by N variables, like ceres::Jet; conversion from double is explicit.
template <int N> struct Jet {
    double a, v[N];
    Jet() : a(0), v() {}
    explicit Jet(double number) : a(number), v() {}
    Jet(double number, int k) : a(number), v() { v[k] = 1; }
};
template <int N> Jet<N> chain(double a, double by_f, const Jet<N> &f, double by_g, const Jet<N> &g)
{
    Jet<N> made(a);
    for (int i = 0; i < N; ++i) made.v[i] = by_f * f.v[i] + by_g * g.v[i];
    return made;
}
template <int N> Jet<N> operator+(const Jet<N> &f, const Jet<N> &g) { return chain(f.a + g.a, 1, f, 1, g); }
template <int N> Jet<N> operator-(const Jet<N> &f, const Jet<N> &g) { return chain(f.a - g.a, 1, f, -1, g); }
template <int N> Jet<N> operator-(const Jet<N> &f) { return chain(-f.a, -1, f, 0, f); }
template <int N> Jet<N> operator*(const Jet<N> &f, const Jet<N> &g) { return chain(f.a * g.a, g.a, f, f.a, g); }
template <int N> Jet<N> operator/(const Jet<N> &f, const Jet<N> &g)
{
    return chain(f.a / g.a, 1 / g.a, f, -f.a / (g.a * g.a), g);
}
template <int N> bool operator<(const Jet<N> &f, const Jet<N> &g) { return f.a < g.a; }
template <int N> bool operator==(const Jet<N> &f, const Jet<N> &g) { return f.a == g.a; }
template <int N> Jet<N> abs(const Jet<N> &f) { return f.a < 0 ? -f : f; }
template <int N> Jet<N> sqrt(const Jet<N> &f) { return chain(std::sqrt(f.a), 0.5 / std::sqrt(f.a), f, 0, f); }
template <int N> Jet<N> tan(const Jet<N> &f) { return chain(std::tan(f.a), 1 + std::tan(f.a) * std::tan(f.a), f, 0, f); }
template <int N> Jet<N> expm1(const Jet<N> &f) { return chain(std::expm1(f.a), std::exp(f.a), f, 0, f); }
template <int N> Jet<N> log1p(const Jet<N> &f) { return chain(std::log1p(f.a), 1 / (1 + f.a), f, 0, f); }
template <int N> Jet<N> atan2(const Jet<N> &g, const Jet<N> &f)
{
    const double square = f.a * f.a + g.a * g.a;
    return chain(std::atan2(g.a, f.a), f.a / square, g, -g.a / square, f);
}
