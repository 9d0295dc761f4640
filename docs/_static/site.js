// A button on each block of code copies it: of a session its statements alone, of a shell block no prompt.
const copied = block => {
  const lines = block.textContent.replace(/\n$/, "").split("\n");
  const session = lines.some(line => line.startsWith(">>> "));
  const kept = session ? lines.filter(line => /^(>>>|\.\.\.)( |$)/.test(line)) : lines;
  return kept.map(line => line.replace(/^(>>>|\.\.\.|\$)( |$)/, "")).join("\n") + "\n";
};

document.addEventListener("DOMContentLoaded", () => {
  for (const block of document.querySelectorAll(".bd-article div.highlight > pre")) {
    if (block.closest(".cell_output") || location.pathname.includes("/_modules/")) continue;
    const button = document.createElement("button");
    button.className = "copy-code";
    button.type = "button";
    button.textContent = "copy";
    button.addEventListener("click", async () => {
      await navigator.clipboard.writeText(copied(block));
      button.textContent = "copied";
      setTimeout(() => { button.textContent = "copy"; }, 1500);
    });
    block.parentElement.append(button);
  }
  // A table that is wider than its place says so; folded ones are measured when they open.
  const mark = table => table.classList.toggle("scrolls", table.scrollWidth > table.clientWidth + 1);
  // The mark changes a table's height, so it waits for the next frame.
  const seen = new ResizeObserver(entries => requestAnimationFrame(() => entries.forEach(entry => mark(entry.target))));
  document.querySelectorAll(".bd-article table").forEach(table => seen.observe(table));
});

// Reports of many entries have a field that leaves those that contain its words.
document.addEventListener("DOMContentLoaded", () => {
  const article = document.querySelector(".bd-article"), entries = [...article?.querySelectorAll("details") ?? []];
  const first = article?.querySelector("section > section");
  if (entries.length < 40 || !first) return;
  const field = document.createElement("input");
  field.type = "search";
  field.className = "filter-entries form-control";
  field.placeholder = field.ariaLabel = "Show only entries with …";
  // A line is found by its own words and by the titles of what folds it; what folds others opens while words are sought.
  const lines = [...entries, ...article.querySelectorAll("tbody tr")];
  const titles = line => line && `${line.querySelector("summary")?.textContent ?? ""} ${titles(line.parentElement.closest("details"))}`;
  const words = new Map(lines.map(line => [line, `${line.textContent} ${titles(line)}`.toLowerCase()]));
  const folders = entries.filter(entry => entry.querySelector("details, table"));
  field.addEventListener("input", () => {
    const sought = field.value.toLowerCase().split(/\s+/).filter(word => word && word !== "the");
    for (const [line, text] of words) line.hidden = !sought.every(word => text.includes(word));
    for (const folder of folders) folder.open = sought.length > 0 && !folder.hidden;
  });
  first.before(field);
});

// A reader who comes from the page of a chart sees the examples of functions in that chart.
document.addEventListener("DOMContentLoaded", () => {
  const asked = new URLSearchParams(location.search).get("chart");
  if (asked) sessionStorage.setItem("chart", asked);
  const chart = sessionStorage.getItem("chart"), data = document.getElementById("chart-examples");
  const found = data && JSON.parse(data.textContent)[chart];
  if (found === undefined || found === null || chart === "cayley2") return;
  const article = document.querySelector(".bd-article"), block = article.querySelector("dl.py div.highlight > pre");
  if (found) block.innerHTML = found;
  const texts = document.createTreeWalker(article, NodeFilter.SHOW_TEXT);
  for (let node; node = texts.nextNode();)
    if (!node.parentNode.closest("details, script, a")) node.data = node.data.replaceAll("cayley2", chart);
  const back = document.createElement("p");
  back.innerHTML = `<a href="${location.pathname}?chart=cayley2">Show the example of cayley2</a>`;
  block.closest("div.highlight").after(back);
});
