// Between require.js and html-manager, on pages with widgets only: where the widget code is,
// and how its labels reach MathJax 3.

(() => {
  const web = new URL("web/", document.currentScript.src).href;

  // Nothing may fall back to a public server: an unknown module is an error in its place.
  window.requirejs.config({
    baseUrl: web,
    paths: {
      anywidget: "anywidget/index",
      "@jupyter-widgets": "html-manager",
      "@jupyter-widgets/html-manager/dist": "html-manager",
    },
  });

  // html-manager typesets with MathJax 2's MathJax.Hub.Queue(["Typeset", hub, element]).
  window.addEventListener("load", () => {
    const mathjax = window.MathJax;
    if (mathjax?.startup?.promise === undefined) return;
    mathjax.Hub = {
      Queue: ([, , element]) =>
        mathjax.startup.promise.then(() => mathjax.typesetPromise([element])),
    };
  });
})();
