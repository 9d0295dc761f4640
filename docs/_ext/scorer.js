// Order of search results: what reports and the changelog say comes after all else, their titles do not.
const REPORTS = new Set(["errata", "field", "theorems", "benchmarks", "accuracy", "changelog"]);
var Scorer = {
  objNameMatch: 11, objPartialMatch: 6, objPrio: {0: 15, 1: 5, 2: -5}, objPrioDefault: 0,
  title: 15, partialTitle: 7, term: 5, partialTerm: 2,
  score: ([page, , , , score, , kind]) => kind === "text" && REPORTS.has(page) ? score - 100 : score,
};
