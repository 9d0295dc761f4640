// Call every function with wrong arguments, with NaN, and with arrays for its results; print what is wrong.
const { folder, functions } = JSON.parse(process.argv[2]), wrong = [];
const make = (size, value = 0.125) => (size === 1 ? value : Array(size).fill(value));
const listed = result => (Array.isArray(result) ? result : [result]).flatMap(part => (part.length ? [...part] : part));
const same = (one, other) => listed(one).every((number, place) => Object.is(number, listed(other)[place]));
const require = (found, name, what) => { if (!found) wrong.push(`${name}: ${what}`); };
const expect = (message, name, run) => {
    let said = "nothing";
    try { run(); } catch (error) { said = `${error.name}: ${error.message}`; }
    require(said.startsWith(message), name, `${said}, not ${message}`);
};

for (const { file, name, given, branch, made } of functions) {
    const module = await import(`${folder}/${file}`), run = module[name];
    const good = given.map(({ size }) => make(size)), more = branch ? [1] : [], right = run(...good, ...more);
    given.forEach(({ argument, size }, place) => {
        const call = value => run(...good.with(place, value), ...more);
        const message = size === 1 ? `TypeError: ${argument}: expected a number` : `RangeError: ${argument}: expected ${size} numbers`;
        for (const [value, shown] of [[Array(size + 1).fill(0), `an array of ${size + 1}`], ["0", "string"], [null, "null"], [undefined, "undefined"]])
            expect(`${message}, given ${shown}`, name, () => call(value));
        if (size > 1) expect(`TypeError: ${argument}[1]: expected a number, given string`, name, () => call(make(size).with(1, "0")));
        require(listed(call(make(size, NaN))).some(Number.isNaN), name, `no NaN of ${argument}`);
    });
    if (branch) require(same(run(...good, 1 - module.CHART.branches), right), name, "wrong results of a negative branch");
    if (branch) for (const k of [0.5, NaN, "1", null]) expect("RangeError: branch: expected an integer", name, () => run(...good, k));
    if (typeof right === "number") continue;
    const room = made.length > 1 ? made.map(size => make(size)) : make(made[0]);
    require(run(...good, ...more, room) === room && same(room, right), name, "wrong results in out");
    expect("RangeError: out: expected", name, () => run(...good, ...more, null));
    const part = made.findIndex(size => size > 1);
    if (made.length > 1) expect(`RangeError: out[${part}]: expected`, name, () => run(...good, ...more, room.with(part, [])));
    const place = given.findIndex(({ size }) => size === made[0]);
    if (made.length === 1 && place >= 0) require(same(run(...good, ...more, good[place]), right), name, "wrong results in an argument");
}
console.log(JSON.stringify(wrong));
