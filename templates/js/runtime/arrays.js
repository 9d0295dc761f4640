// Arguments and results of the functions of every chart.

function shown(value) {
    if (value !== null && typeof value === "object" && "length" in value) return `an array of ${value.length}`;
    return value === null || typeof value === "number" ? `${value}` : typeof value;
}

function sized(name, array, size) {
    if (array === null || typeof array !== "object" || array.length !== size)
        throw new RangeError(`${name}: expected ${size} numbers, given ${shown(array)}`);
}

/** Require an argument of so many numbers. */
export function given(name, array, size) {
    sized(name, array, size);
    for (let i = 0; i < size; i++) number(`${name}[${i}]`, array[i]);
}

/** Require an argument that is a number. */
export function number(name, value) {
    if (typeof value !== "number") throw new TypeError(`${name}: expected a number, given ${shown(value)}`);
}

/** Return a branch modulo the number of branches; any integer if there are infinitely many. */
export function branch_of(branch, branches) {
    if (!Number.isInteger(branch)) throw new RangeError(`branch: expected an integer, given ${shown(branch)}`);
    return branches ? ((branch % branches) + branches) % branches : branch;
}

/** Copy results into an array, and return it. */
export function stored(made, start, size, out, name = "out") {
    sized(name, out, size);
    for (let i = 0; i < size; i++) out[i] = made[start + i];
    return out;
}

/** Copy results into the arrays of a list, and numbers into the list, and return it. */
export function parted(made, sizes, out) {
    sized("out", out, sizes.length);
    let start = 0;
    for (let part = 0; part < sizes.length; part++) {
        if (sizes[part] > 1) stored(made, start, sizes[part], out[part], `out[${part}]`);
        else out[part] = made[start];
        start += sizes[part];
    }
    return out;
}
