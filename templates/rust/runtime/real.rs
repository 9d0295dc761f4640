//! Real numbers: `f64`, `f32`, or a type of your own.
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Real number type of all functions.
///
/// `f64` and `f32` have it with the feature `std`. Without it, wrap one in a type of your own.
pub trait Real:
    Copy
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Small integer, exactly.
    fn of(integer: i32) -> Self;
    /// Decimal constant, rounded to both types.
    fn number(double: f64, single: f32) -> Self;
    /// Magnitude.
    fn abs(self) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Tangent.
    fn tan(self) -> Self;
    /// Angle of the point (x, self) in (-pi, pi].
    fn atan2(self, x: Self) -> Self;
    /// Exponential minus 1.
    fn exp_m1(self) -> Self;
    /// Natural logarithm of 1 + self.
    fn ln_1p(self) -> Self;
}

/// Value for a condition: `one` if it is true, else `other`.
#[inline(always)]
pub(crate) fn select<T>(condition: bool, one: T, other: T) -> T {
    if condition {
        one
    } else {
        other
    }
}

#[cfg(feature = "std")]
macro_rules! real {
    ($type:ident, $double:ident, $single:ident => $constant:ident, $($function:ident: $path:path),*) => {
        impl Real for $type {
            #[inline(always)]
            fn of(integer: i32) -> Self {
                integer as Self
            }
            #[inline(always)]
            fn number($double: f64, $single: f32) -> Self {
                $constant
            }
            $(real!(@ $function $path);)*
        }
    };
    (@ atan2 $path:path) => {
        #[inline(always)]
        fn atan2(self, x: Self) -> Self {
            $path(self, x)
        }
    };
    (@ $function:ident $path:path) => {
        #[inline(always)]
        fn $function(self) -> Self {
            $path(self)
        }
    };
}

#[cfg(feature = "std")]
mod of_std {
    use super::Real;
    real!(f64, double, _single => double, abs: f64::abs, sqrt: f64::sqrt, tan: f64::tan, atan2: f64::atan2,
          exp_m1: f64::exp_m1, ln_1p: f64::ln_1p);
    real!(f32, _double, single => single, abs: f32::abs, sqrt: f32::sqrt, tan: f32::tan, atan2: f32::atan2,
          exp_m1: f32::exp_m1, ln_1p: f32::ln_1p);
}
