// Building the page. Text of the program only ever becomes text nodes.

const SVG = 'http://www.w3.org/2000/svg';

function fill(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name === 'on') {
      Object.entries(value).forEach(([type, listener]) => node.addEventListener(type, listener));
    } else if (value !== null && value !== undefined && value !== false) {
      node.setAttribute(name, value === true ? '' : value);
    }
  }
  node.append(...children.filter((child) => child !== null && child !== undefined));
  return node;
}

/** An HTML element; the attribute `on` holds listeners by type. */
function html(tag, attributes = {}, ...children) {
  return fill(document.createElement(tag), attributes, children);
}

/** An SVG element. */
function svg(tag, attributes = {}, ...children) {
  return fill(document.createElementNS(SVG, tag), attributes, children);
}

/** A line icon of 20 by 20. */
function icon(path) {
  return svg('svg', {viewBox: '0 0 20 20', class: 'icon', 'aria-hidden': 'true'}, svg('path', {d: path}));
}

function number(value, places = 0) {
  if (!Number.isFinite(value)) {
    return '–';
  }
  const text = value.toFixed(places);
  return Number(text) === 0 ? (0).toFixed(places) : text.replace('-', '−');
}

/** 83.4 → 1:23.40 */
function clock(time, places = 2) {
  const unit = 10 ** places;
  const ticks = Math.floor(time * unit + 1e-6);
  const seconds = ticks / unit;
  const minutes = Math.floor(seconds / 60);
  return `${minutes}:${(seconds - minutes * 60).toFixed(places).padStart(places > 0 ? 3 + places : 2, '0')}`;
}

/** 0.172 → 172 ms; 2.7512 → 2.75 s */
function period(seconds) {
  return seconds < 1 ? `${Math.round(seconds * 1000)} ms` : seconds < 100 ? `${seconds.toFixed(2)} s` : `${Math.round(seconds)} s`;
}

/** A CSS colour as a canvas takes it: variables of the theme resolved. */
function cssColour(colour) {
  const variable = /^var\((.*)\)$/.exec(colour);
  return variable ? themeColour(variable[1]) : colour;
}

function themeColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}
