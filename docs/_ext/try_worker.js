// Worker of the page "Try it": Python with the toolkit, from files that the page has loaded; it fetches nothing.
let answered;

const start = async files => {
  const address = name => URL.createObjectURL(new Blob([files[name]], { type: "text/javascript" }));
  self.fetch = async asked => {
    const file = files[`${asked.url ?? asked}`.split("/").pop()];
    return new Response(file, { status: file ? 200 : 404, headers: { "Content-Type": "application/wasm" } });
  };
  const [{ loadPyodide }, { default: createPyodideModule }] =
    await Promise.all([import(address("pyodide.mjs")), import(address("pyodide.asm.mjs"))]);
  const { info } = await new Response(files["pyodide-lock.json"]).json();
  const lockFileContents = JSON.stringify({ info, packages: {} });
  const python = await loadPyodide({ indexURL: "https://local.invalid/", createPyodideModule, lockFileContents });
  const extractDir = python.runPython("import site; site.getsitepackages()[0]");
  for (const name of ["libraries.zip", "toolkit.zip"]) python.unpackArchive(files[name], "zip", { extractDir });
  answered = python.pyimport("answers").answered;
};

self.onmessage = async ({ data: { files, name, form } }) => {
  try {
    if (files) await start(files);
    postMessage({ answer: name ? answered(name, form, early => postMessage({ early })) : "{}" });
  } catch (error) {
    postMessage({ answer: JSON.stringify({ errors: [`${error.message ?? error}`.trim().split("\n").pop()] }) });
  }
};
