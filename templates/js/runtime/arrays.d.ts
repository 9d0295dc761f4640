/** Numbers of a vector or, row by row, of a matrix: an array of numbers or a Float64Array, for example. */
export type Numbers = ArrayLike<number>;
/** Array for results. */
export type Out = number[] | Float64Array | Float32Array;
