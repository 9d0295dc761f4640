//! Rigid displacements and rotations by vectors v = phi(alpha) u, without allocation.
//!
//! Each module is a chart: `cayley2`, for example, holds the functions of the Cayley map of order 2. Modules in
//! `rotation` are for rotations alone. alpha is the dual angle (rotation angle in rad, translation along the axis), and
//! u the unit dual vector of the screw axis. Dual quantities store the real part first, then the dual part.
//!
//! Every function has two forms: one for a value, and one with the ending `_rows` for slices, which computes as many
//! values as the shortest slice has. No function allocates or panics. NaN arguments give NaN results. A singularity
//! gives inf or NaN. An argument `branch` is any integer, taken modulo the number of branches; 0 is the principal one.
//!
//! Functions are generic over [`Real`], that is `f64`, `f32` or a type of yours. Results are equal to those of the C
//! headers to the bit, if these are compiled with -ffp-contract=off and use the same `tan`, `atan2` and the like.
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]
// Generated programs: x - x is 0 or NaN, some need no chart, and each value has the name of the formula.
#![allow(clippy::approx_constant, clippy::eq_op, clippy::extra_unused_type_parameters, clippy::let_and_return)]
#![allow(clippy::too_many_arguments, clippy::type_complexity)]

#[cfg(feature = "std")]
extern crate std;

mod scalars;
mod geometry;
mod real;

pub use scalars::Chart;
pub use real::Real;

include!(concat!(env!("OUT_DIR"), "/charts.rs"));

/// Charts for rotations alone.
pub mod rotation {
    #[path = "geometry.rs"]
    mod geometry;

    include!(concat!(env!("OUT_DIR"), "/rotations.rs"));
}
