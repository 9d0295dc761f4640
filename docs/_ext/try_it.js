const home = document.getElementById("try-it"), data = JSON.parse(document.getElementById("try-it-data").textContent);
const find = what => home.querySelector(what), [claim, chart] = home.querySelectorAll("form");
const state = find(".state"), bar = find("progress"), stop = find(".stop"), letters = find(".letters");
const total = data.files.reduce((sum, file) => sum + file.size, 0), mega = bytes => (bytes / 1e6).toFixed(0);
const made = (tag, properties, ...inside) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...inside);
  return element;
};

// Forms: letters are rows of a name and a kind; the address of the page, or an example, fills them.
const kinds = Object.keys(data.kinds).flatMap(kind => [kind, data.constant + kind]);
const addLetter = (name = "", kind = "vector") => {
  const options = kinds.map(text => made("option", { title: data.kinds[text] ?? "" }, text));
  const chosen = made("select", { ariaLabel: "kind" }, ...options);
  chosen.value = kind;
  const remove = made("button", { type: "button", title: "remove", onclick: () => row.remove() }, "×");
  const row = made("div", {}, made("input", { value: name, ariaLabel: "letter", spellcheck: false }), chosen, remove);
  letters.append(row);
};
const fill = ({ letters: declared = "", ...texts }) => {
  letters.replaceChildren();
  for (const row of declared.split(";").filter(part => part.trim())) addLetter(...row.split("=").map(part => part.trim()));
  for (const name of ["claim", "domain", "definitions"]) claim.elements[name].value = texts[name] ?? "";
  find("details").open = Boolean(texts.definitions);
};
const read = form => {
  const rows = [...letters.children].map(row => [...row.querySelectorAll("input, select")].map(field => field.value.trim()));
  return {
    ...Object.fromEntries(new FormData(form)),
    letters: rows.filter(([name]) => name).map(row => row.join(" = ")).join("; "),
  };
};
home.addEventListener("click", ({ target }) => {
  const form = target.closest("form");
  if (target.matches(".more")) addLetter();
  if (!target.matches(".examples button")) return;
  if (form === claim) fill(data.examples[target.value]); else chart.elements.chart.value = target.value;
  form.requestSubmit();
});
const asked = Object.fromEntries(new URLSearchParams(location.search));
fill(asked.claim ? asked : Object.values(data.examples)[0]);
if (asked.entry) fetch("_static/claims.json").then(found => found.json()).then(all => fill(all[asked.entry] ?? {}));

// Engine: its files are loaded once and kept, so a worker that was ended begins again without the network.
let files, worker;
const load = async () => {
  let done = 0;
  Object.assign(bar, { max: total, value: 0 });
  return Object.fromEntries(await Promise.all(data.files.map(async ({ name, hash }) => {
    const response = await fetch(`_static/engine/${name}?${hash}`, { cache: "force-cache" }), parts = [];
    if (!response.ok) throw new Error(`${name} cannot be loaded (${response.status})`);
    for (let reader = response.body.getReader(), part; !(part = await reader.read()).done; parts.push(part.value)) {
      bar.value = done += part.value.length;
      state.textContent = `Loading ${mega(done)} of ${mega(total)} MB; the browser keeps them.`;
    }
    return [name, await new Blob(parts).arrayBuffer()];
  })));
};
const told = (message, seconds = 1e6, early) => new Promise((resolve, reject) => {
  const late = setTimeout(() => reject(new Error(`Not decided within ${seconds} s.`)), 1000 * seconds);
  const began = performance.now();
  const clock = setInterval(() => { state.textContent = `Working, ${((performance.now() - began) / 1000).toFixed(0)} s`; }, 500);
  const settled = settle => value => { clearTimeout(late); clearInterval(clock); settle(value); };
  worker.onmessage = ({ data: found }) => (found.early ? early(JSON.parse(found.early)) : settled(resolve)(JSON.parse(found.answer)));
  worker.onerror = event => settled(reject)(new Error(event.message));
  stop.onclick = () => settled(reject)(new Error("Stopped."));
  worker.postMessage(message);
});
const begin = async () => {
  files ??= await load();
  await window.MathJax?.startup?.promise;
  await window.MathJax?.startup?.document.lazyTypesetAll();
  await Promise.all([...document.fonts].map(font => font.load()));  // of later formulas too: the network may go
  bar.removeAttribute("value");
  worker = new Worker(URL.createObjectURL(new Blob([data.worker], { type: "text/javascript" })), { type: "module" });
  const { errors } = await told({ files });
  if (errors) throw new Error(errors[0]);
};
const ask = async (name, form, early) => {
  if (!worker) await begin();
  return told({ name, form: JSON.stringify(form) }, Number(form.seconds), early);
};

// Answers
const formula = latex => made("span", {}, `\\(\\displaystyle ${latex}\\)`);
const failed = ({ errors }) => errors && errors.map(line => made("p", { className: "error" }, line));
const verdict = (found, more = "") => failed(found) ?? [
  made("p", {}, made("strong", { className: found.status }, found.status), `: ${found.meaning}${more}`),
  made("p", {}, formula(found.claim)),
  made("dl", {}, ...found.rows.flatMap(([label, pieces]) => [
    made("dt", {}, label), ...pieces.map(({ text, latex }) => made("dd", {}, text, ...(latex ? [formula(latex)] : []))),
  ])),
];
const code = (title, text) => made("details", {}, made("summary", {}, title),
  made("button", { type: "button", onclick: () => navigator.clipboard.writeText(text) }, "copy"), made("pre", {}, text));
const answers = {
  async claim(form, show) {
    await show(verdict(await ask("decided", form, found => show(verdict(found, " (still looking for more)")))));
  },
  async chart(form, show) {
    const found = await ask("shown", form);
    const formulas = failed(found) ?? [...found.latex.map(text => made("p", {}, formula(text))), code("as text", found.text)];
    await show(formulas);
    if (found.errors || !form.target) return;
    const kernels = await ask("printed", form), note = "Proved and printed, not run: dualcay generate runs kernels before it saves them.";
    await show([...formulas, ...(failed(kernels) ?? [made("p", {}, note), ...Object.entries(kernels.files).map(row => code(...row))])]);
  },
};
home.addEventListener("submit", async event => {
  event.preventDefault();
  const form = event.target, place = form.nextElementSibling, buttons = home.querySelectorAll("button:not(.stop)");
  const show = async nodes => {
    place.replaceChildren(...nodes);
    await window.MathJax?.typesetPromise?.([place]);
    await window.MathJax?.startup?.document.lazyTypesetAll();
  };
  const work = on => {
    stop.hidden = bar.hidden = !on;
    for (const button of buttons) button.disabled = on;
  };
  work(true);
  try {
    await show([]);
    await answers[form.name](read(form), show);
    state.textContent = "Ready.";
  } catch (error) {
    worker?.terminate();
    worker = undefined;
    state.textContent = error.message;
  }
  work(false);
  home.dispatchEvent(new Event("answered"));
});
if (!total) for (const button of home.querySelectorAll("form > button, .examples button")) button.disabled = true;
state.textContent = total ? `The first question loads ${mega(total)} MB. Nothing that you type leaves your browser.`
  : "This build of the site has no engine: Pyodide or python-flint could not be downloaded.";
