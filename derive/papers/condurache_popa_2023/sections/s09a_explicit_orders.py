"""Section 9, explicit formulas for orders 1 to 5: lines 417-456."""

from . import *
from .general_order import *
from .s07b_order_lists import o1, o2, o3, o4, o5, p4, p5, q4, q5, x2

p5_printed = 1 - 10 * x + x2

ENTRIES = (
    o1.vector("92"), *o1.each_polynomial("93", "94"), o1.quaternion("95"), o1.tensor("96"),
    o1.equation("97", equal(o1.dcay, 2 / (1 + x) * (I + V))),
    o1.equation("98", equal(o1.dcay_inv, half * I - half * V + half * VV)),
    o2.vectors("99"), *o2.each_polynomial("100", "101"), o2.quaternion("102"), o2.tensor("103"),
    o2.equation("104", equal(o2.dcay, 4 / (1 + x)**2 * ((1 - x) * I + 2 * V + 2 * VV))),
    o2.equation("105", equal(o2.dcay_inv, (1 - x) / 2 * I - half * V + half * VV),
                corrected=equal(o2.dcay_inv, (1 - x) / 4 * I - half * V + half * VV)),
    o3.vectors("106"), *o3.each_polynomial("107", "108"), o3.quaternion("109"), o3.tensor("110"),
    o3.equation("111",
                equal(o3.dcay, 2 / (1 + x)**3 * ((1 - 3 * x) * (3 - x) * I + (3 - x)**2 * V + (16 + 9 * x) * VV)),
                corrected=equal(
                    o3.dcay, 2 / (1 + x)**3 * ((1 - 3 * x) * (3 - x) * I + (3 - x)**2 * V + 16 * VV))),
    o3.equation("112", equal(o3.dcay_inv, (1 - 3 * x) / (3 - x) * I - half * V + (11 - x) / (6 * (3 - x)) * VV),
                condition=nonzero(Re(3 - x)),
                corrected=equal(
                    o3.dcay_inv, (1 - 3 * x) / (2 * (3 - x)) * I - half * V + (11 - x) / (6 * (3 - x)) * VV)),
    o4.vectors("113"), *o4.each_polynomial("114", "115"), o4.quaternion("116"), o4.tensor("117"),
    o4.equation("118", equal(o4.dcay, 8 / (1 + x)**4 * (p4 * (1 - x) * I + q4 * V + (x2 - 3 * x + 10) * VV)),
                corrected=equal(o4.dcay, 8 / (1 + x)**4 * (
                    p4 * (1 - x) * I + 4 * (1 - x)**2 * V + (2 * x2 - 4 * x + 10) * VV))),
    o4.equation("119", equal(o4.dcay_inv, p4 / (8 * (1 - x)) * I - half * V - (8 * x + 3) / (8 * (1 - x)) * VV),
                condition=nonzero(Re(1 - x)),
                corrected=equal(o4.dcay_inv, p4 / (8 * (1 - x)) * I - half * V + (3 - x) / (4 * (1 - x)) * VV)),
    o5.vectors("120"), o5.polynomials("121"), o5.quaternion("122"), o5.tensor("123"),
    o5.equation("124", equal(o5.dcay, 2 / (1 + x)**5 * (p5_printed * q5 * I + q5 * V + (40 - 48 * x + 40 * x2) * VV)),
                corrected=equal(
                    o5.dcay, 2 / (1 + x)**5 * (p5 * q5 * I + q5**2 * V + (80 - 96 * x + 80 * x2) * VV))),
    o5.equation("125", equal(o5.dcay_inv, p5_printed / (2 * q5) * I - half * V + (45 - 16 * x + x2) / (10 * q5) * VV),
                condition=nonzero(Re(q5)),
                corrected=equal(
                    o5.dcay_inv, p5 / (2 * q5) * I - half * V + (45 - 34 * x + x2) / (10 * q5) * VV)),
)
