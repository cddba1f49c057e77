// Interactive charts where the libraries were built in, and tables that sort. Without this script the page says the same.
'use strict';
(() => {
  const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

  const theme = () => {
    const ink = style('--quiet');
    const axis = { labelColor: ink, titleColor: ink, gridColor: style('--line'), domainColor: ink, tickColor: ink,
                   titleFontWeight: 'normal', titleFontSize: 12, labelFontSize: 11, tickCount: 6 };
    return {
      background: 'transparent',
      font: getComputedStyle(document.body).fontFamily,
      view: { stroke: null },
      axis,
      axisX: { grid: false },
      axisY: { domain: false, ticks: false },
      range: { category: Array.from({ length: 8 }, (_, i) => style(`--series-${i}`)) },
    };
  };

  // A click on a legend's entry brings out its series, a second click all of them.
  const enliven = (figure) => {
    for (const entry of figure.querySelectorAll('.legend li')) {
      if (!entry.querySelector('button')) {
        const button = document.createElement('button');
        button.append(...entry.childNodes);
        button.setAttribute('aria-pressed', 'false');
        entry.append(button);
        button.addEventListener('click', () => {
          const pick = button.getAttribute('aria-pressed') === 'false';
          for (const other of figure.querySelectorAll('.legend button'))
            other.setAttribute('aria-pressed', String(pick && other === button));
          drawn.get(figure).view.signal('picked', pick ? entry.dataset.series : '').run();
        });
      }
    }
  };

  // Drawn when it first becomes visible: a chart inside a closed <details> has no width to fill.
  const drawn = new Map();
  const draw = async (figure) => {
    const spec = JSON.parse(figure.querySelector('script[type="application/json"]').textContent);
    let target = figure.querySelector('.interactive');
    if (!target) {
      target = document.createElement('div');
      target.className = 'interactive';
      figure.querySelector('.static').after(target);
    }
    const still = figure.querySelector('.static');
    try {
      drawn.get(figure)?.finalize();
      // ast: expressions are interpreted, not compiled, so that the page can forbid eval.
      drawn.set(figure, await vegaEmbed(target, spec, { config: theme(), renderer: 'svg', actions: false, ast: true }));
      still.hidden = true;
      figure.dataset.drawn = 'true';
      enliven(figure);
    } catch (error) {
      target.remove();
      still.hidden = false;
      console.error(error);
    }
  };

  if (typeof vegaEmbed === 'function') {
    const watcher = new IntersectionObserver((entries) => {
      for (const entry of entries) {
        if (!entry.isIntersecting || drawn.has(entry.target)) continue;
        drawn.set(entry.target, null);
        draw(entry.target);
      }
    }, { rootMargin: '400px' });
    for (const figure of document.querySelectorAll('.chart')) watcher.observe(figure);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
      for (const figure of [...drawn.keys()]) draw(figure);
    });
    // Paper gets the static charts, which need no width of a window.
    addEventListener('beforeprint', () => document.querySelectorAll('.chart').forEach((figure) => {
      figure.querySelector('.static').hidden = false;
      figure.querySelector('.interactive')?.setAttribute('hidden', '');
    }));
    addEventListener('afterprint', () => document.querySelectorAll('.chart[data-drawn]').forEach((figure) => {
      figure.querySelector('.static').hidden = true;
      figure.querySelector('.interactive')?.removeAttribute('hidden');
    }));
  }

  for (const table of document.querySelectorAll('table.sortable')) {
    const heads = [...table.tHead.rows[0].cells];
    heads.forEach((head, column) => {
      const button = document.createElement('button');
      button.textContent = head.textContent;
      head.replaceChildren(button);
      button.addEventListener('click', () => {
        const descending = head.getAttribute('aria-sort') === 'ascending';
        for (const other of heads) other.removeAttribute('aria-sort');
        head.setAttribute('aria-sort', descending ? 'descending' : 'ascending');
        const text = (row) => row.cells[column].textContent;
        const order = new Intl.Collator('en', { numeric: true }).compare;
        const rows = [...table.tBodies[0].rows].sort((a, b) => order(text(a), text(b)) * (descending ? -1 : 1));
        table.tBodies[0].append(...rows);
      });
    });
  }

  // A link to a claim opens its evidence.
  const open = () => {
    const target = location.hash.startsWith('#claim-') && document.getElementById(location.hash.slice(1));
    if (target) target.querySelector('details').open = true;
  };
  addEventListener('hashchange', open);
  open();
})();
