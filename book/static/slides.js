// A deck starts when its formulas stand. Keys inside an explorer belong to the explorer;
// Escape gives them back to the deck. The key D changes between light and dark.

(() => {
  const inside = (element) => element?.closest?.(".jupyter-widgets, .widget-subarea");

  const start = () =>
    window.Reveal.initialize({
      width: 1280,
      height: 720,
      margin: 0.02,
      center: false,
      hash: true,
      navigationMode: "linear",
      slideNumber: "c/t",
      transition: "none",
      backgroundTransition: "none",
      scrollActivationWidth: null,
      keyboardCondition: (event) => !event.defaultPrevented && !inside(event.target),
      plugins: [window.RevealNotes],
    });

  const changeTheme = () => {
    const { dataset } = document.documentElement;
    dataset.theme = dataset.theme === "dark" ? "light" : "dark";
  };

  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && inside(event.target)) event.target.blur();
  });

  for (const link of document.querySelectorAll(".slides a:not([href^='#'])")) {
    link.target = "_blank";
  }

  // A slide that is too full is set smaller, down to about half; what is left scrolls.
  const isFull = (slide) =>
    slide.scrollHeight > slide.clientHeight ||
    [...slide.querySelectorAll("div.math, .output")].some((box) =>
      box.scrollWidth > box.clientWidth + 1);
  const frames = () =>
    new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));

  // An explorer is laid out at the width at which, zoomed to the slide, text and pictures are large.
  const WIDTHS = [1200, 1080, 960, 840, 720, 600];
  const fitExplorer = async (slide, explorer) => {
    if (slide.dataset.fitted) return;
    slide.dataset.fitted = true;
    const scale = window.Reveal.getScale();
    const height = (box) => box.getBoundingClientRect().height / scale;
    let best = { score: 0 };
    for (const width of WIDTHS) {
      explorer.style.width = `${width}px`;
      await frames();
      const others = [...slide.children].reduce((sum, child) => sum + height(child), 0)
        - height(explorer);
      const zoom = Math.min(1200 / width, (slide.clientHeight - 90 - others) / height(explorer));
      const score = zoom * zoom * width;
      if (score > best.score) best = { width, zoom, score };
    }
    explorer.style.width = `${best.width}px`;
    explorer.style.zoom = best.zoom;
  };

  const fit = (slide) => {
    const explorer = slide.querySelector(".ft-explorer");
    if (explorer) fitExplorer(slide, explorer);
    for (let size = 30; !explorer && size >= 17 && isFull(slide); size -= 1) {
      slide.style.fontSize = `${size}px`;
    }
  };

  // The speaker's window has no styles that would hide a formula's second, spoken form.
  const speak = () => {
    for (const spoken of document.querySelectorAll("aside.notes mjx-assistive-mml")) {
      spoken.remove();
    }
  };

  window.MathJax.startup.promise.then(speak).then(start).then(() => {
    window.Reveal.addKeyBinding({ keyCode: 68, key: "D", description: "Dark or light" },
      changeTheme);
    // An explorer takes its size when it comes into sight.
    const look = () => {
      const slide = window.Reveal.getCurrentSlide();
      window.setTimeout(() => fit(slide), slide.querySelector(".ft-explorer") ? 300 : 0);
    };
    window.Reveal.on("slidechanged", look);
    look();
  });
})();
