"""Check the polynomials of certificates, not which equation they belong to: the words of a claim are not read.

``python tools/check_certificates.py FILE`` needs Python's standard library only. It multiplies out denominators, moves
the terms of inductions itself, divides by the relations, and requires that 0 remains. The exit code is 1 for refused
certificates, 3 for an unreadable file. A polynomial maps monomials to numbers; exponents are packed into one integer,
64 bits each. The lowest bits belong to epsilon with epsilon² = 0: f(x + epsilon x') = f + epsilon f'."""
import hashlib
import json
import sys
from fractions import Fraction
from functools import reduce
from itertools import product
from math import comb

EPSILON, MASK = ({1: 1}, {0: 1}), 2**64 - 1
LARGEST, POWERS, LAST = 1000, 400, 50  # exponent, sum of powers of factors, n
MALFORMED = (ArithmeticError, AttributeError, LookupError, RecursionError, TypeError, ValueError)

def require(condition, words):
    if not condition:
        raise ValueError(words)
def multiply(a, b, onto=()):
    """Return a b + onto."""
    total = dict(onto)
    for (key, c), (other, d) in product(a.items(), b.items()):
        total[key + other] = total.get(key + other, 0) + c * d
    return {key: c for key, c in total.items() if c}
def times(s, t):
    return multiply(s[0], t[0]), multiply(s[1], t[1])
def plus(s, t, factor=1):
    if s[1] == t[1]:
        return multiply({0: factor}, t[0], s[0]), s[1]
    return multiply(multiply({0: factor}, t[0]), s[1], multiply(s[0], t[1])), multiply(s[1], t[1])

class Part:
    """Equations in one ring; a side is a pair of polynomials, numerator and denominator."""
    def __init__(self, part):
        self.names = part["variables"]
        self.shifts = [64 * place for place in range(len(self.names), 0, -1)]
        self.relations = [self.read(terms) for terms in part["relations"]]
        leads = [self.occurring({max(relation, default=0): 1}) for relation in self.relations]
        require(all(leads) and len(set().union(*leads)) == sum(map(len, leads)), "the relations may be contradictory")
        self.factors = [self.read(entry["factor"]) for entry in part["factors"]]
        self.free = set(map(self.names.index, part["free"]))
        self.values = [({1 << shift: 1}, {0: 1}) for shift in self.shifts]
        origin = dict.fromkeys(part["free"], ({}, {0: 1})) | {a: self.side(b) for a, b in part["origin"].items()}
        self.origin = [origin.get(name, value) for name, value in zip(self.names, self.values)]
        for entry in part["factors"]:
            require(self.is_nonzero(entry), f"the factor {entry['factor']} may be 0")
        self.labels, self.terms = [equation["label"] for equation in part["equations"]], {}
        for equation in part["equations"]:
            require(not self.remainder(self.difference(equation)), f"{equation['label']!r} is not an identity")
    def read(self, terms):
        found = {sum(e << shift for e, shift in zip(powers, self.shifts, strict=True)): c for c, powers in terms}
        integers = len(found) == len(terms) and all(type(e) is int for c, powers in terms for e in (c, *powers))
        require(integers and all(c and 0 <= e <= LARGEST for c, powers in terms for e in (0, *powers)), "malformed")
        return found
    def side(self, value):
        divisor, powers, terms = value
        right = divisor > 0 and len(powers) <= len(self.factors) and all(type(p) is int for p in (divisor, *powers))
        require(right and min(powers, default=0) >= 0 and sum(powers) <= POWERS, "a power or divisor is out of range")
        below = (factor for factor, power in zip(self.factors, powers) for _ in range(power))
        return self.read(terms), reduce(multiply, below, {0: divisor})
    def exponents(self, key):
        return [key >> shift & MASK for shift in self.shifts]
    def occurring(self, a):
        return {place for key in a for place, e in enumerate(self.exponents(key)) if e}
    def moved(self, a, values):
        """Return a polynomial with a side in place of each variable."""
        powers = ((c, zip(values, self.exponents(key), strict=True)) for key, c in a.items())
        terms = (reduce(times, (side for side, e in sides for _ in range(e)), ({0: c}, {0: 1})) for c, sides in powers)
        return reduce(plus, terms, ({}, {0: 1}))
    def difference(self, equation):
        """Return the numerator of left side minus right side; the left side may be a moved term."""
        right, (kind,) = self.side(equation["right"]), equation.keys() - {"label", "right"}
        stage, _, name = equation["label"].partition(", ")
        require(kind in {"start": ("start",), "law": ("step", "rate")}.get(stage, ("left",)), f"{stage!r} by {kind!r}")
        if kind == "left":
            return plus(self.side(equation["left"]), right, -1)[0]
        term, values = self.side(equation[kind]["term"]), [self.side(value) for value in equation[kind]["values"]]
        require(self.terms.setdefault(name, term) == term, "start and law differ")
        if kind == "rate":
            values = [plus(old, times(EPSILON, rate)) for old, rate in zip(self.values, values, strict=True)]
            right = plus(term, times(EPSILON, right))
        above, below = (self.moved(a, values) for a in term)
        require(self.remainder(below[0]), f"{equation['label']!r} has no value")
        return plus(above, times(right, below), -1)[0]
    def remainder(self, a):
        """Return what remains after division by the relations, whose leading monomials are the greatest ones."""
        a = {key: c for key, c in a.items() if key & MASK < 2}
        for relation in self.relations * len(self.relations):
            lead, least = max(relation), self.exponents(max(relation))
            require(abs(relation[lead]) == 1, "a relation does not begin with 1 or -1")
            while hits := [key for key in a if all(map(int.__ge__, self.exponents(key), least))]:
                a = multiply({key - lead: -a[key] * relation[lead] for key in hits}, relation, a)
        return a
    def is_nonzero(self, entry):
        """Tell whether a factor is not 0: at a point where relations hold, or at the origin, as a power of n."""
        factor, power = self.read(entry.get("base", entry["factor"])), self.read(entry["factor"])
        if power != factor:  # the n-th power of a base is a variable that the relations do not make 0
            (place,) = self.occurring(power)
            require(power == self.values[place][0] and place not in self.free and self.may_be_1(place), "untied factor")
        if "point" not in entry:
            above = self.remainder(self.moved(factor, self.origin)[0])
            return len(above) == 1 and {self.names[place] for place in self.occurring(above)} <= {"n"}
        met = [relation for relation in self.relations if self.occurring(factor) & self.occurring(relation)]
        point = [({0: Fraction(entry["point"].get(name, 0))}, {0: 1}) for name in self.names]
        value, *others = (self.moved(a, point)[0] for a in (factor, *met))
        return value and len(met) <= 1 and not any(others) and self.occurring(factor) <= self.free
    def may_be_1(self, place):
        """Tell whether all relations hold at a point of 1, 0 and -1 where a variable is 1."""
        others = sorted(set().union(*map(self.occurring, self.relations)) - {place})[:9]
        points = ({place: 1, **dict(zip(others, values))} for values in product((1, 0, -1), repeat=len(others)))
        sides = ([({0: point.get(i, 0)}, {0: 1}) for i in range(len(self.names))] for point in points)
        return any(not any(self.moved(relation, values)[0] for relation in self.relations) for values in sides)

def check_series(shown):
    """Check laws of sums of binomials as polynomials in x, at n = 1 … last, or at the start."""
    def series(name, n):
        total, one = {}, shown["sums"][name]
        for j in range(one["start"], 2 * n + 3):
            for above, below, power, alternating, *pair in one["summands"]:
                chosen = comb(*(a * n + b * j + c for a, b, c in pair)) * n**power * (-1) ** (j * alternating)
                total = multiply({j + one["offset"]: Fraction(above, below)}, {0: chosen}, total)
        return total
    part = Part(shown["part"])
    require(type(shown["last"]) is int and 1 < shown["last"] <= LAST, "the last n is out of range")
    for law in shown["laws"]:
        for n in [1] if law["start"] else range(1, shown["last"] + 1):
            values = {0: n}, {1: 1}, *(series(name, a * n + b) for name, a, b in shown["uses"])
            above, _ = part.moved(part.read(law["law"]), [(value, {0: 1}) for value in values])
            require(not above, f"{law['label']!r} is not an identity at n = {n}")
    return [part]

def check(shown, claims):
    """Refuse a certificate unless its text, its premises, its claims and its equations are right."""
    digest = hashlib.sha256(json.dumps({**shown, "sha256": ""}, sort_keys=True).encode()).hexdigest()
    require(shown["sha256"] == digest, "its text does not have the digest that it states")
    require(shown["status"] == "proved" and shown["claims"] and shown["name"] not in claims, "it proves nothing new")
    for cited in shown["premises"]:
        known = cited["by"] == "definition" or cited["claim"] in claims.get(cited["by"], ())
        require(known, f"no theorem before it claims {cited['text']!r}")
    parts = check_series(shown["series"]) if "series" in shown else list(map(Part, shown["parts"]))
    labels = {label.split(", component ")[0] for part in parts for label in part.labels}
    for claim in shown["claims"]:
        decided = {claim, left := claim.split(" = ")[0]} & labels or {f"start, {left}", f"law, {left}"} <= labels
        require(decided or "series" in shown, f"no equation decides {claim!r}")

def main(path):
    refused, claims = [], {}
    try:
        with open(path, encoding="utf-8") as file:
            found = json.load(file)
        names, listed = [str(shown["name"]) for shown in found["certificates"]], len(found["listed"])
    except (OSError, *MALFORMED) as error:
        print(f"{path}: no file of certificates: {error}", file=sys.stderr)
        return 3
    for name, shown in zip(names, found["certificates"]):
        try:
            check(shown, claims)
            claims[name] = shown["claims"]
        except MALFORMED as error:
            refused.append(f"certificate {name!r} is refused: {error or 'malformed'}")
    if (len(names), listed) != (found.get("certified"), found.get("uncertified")):
        refused.append(f"{path}: the numbers of certificates are not as stated")
    print(*refused, f"{len(claims)} of {len(names)} certificates are right", sep="\n")
    return 1 if refused else 0

if __name__ == "__main__":
    sys.exit(main(sys.argv[1]) if len(sys.argv) == 2 else "usage: python tools/check_certificates.py FILE")
