// SPDX-License-Identifier: MIT

function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes ?? {})) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? '' : value);
  }
  // Strings become text nodes, never markup.
  element.append(...children.flat().filter((child) => child !== undefined && child !== null && child !== false));
  return element;
}

/** An HTML element; attributes that start with "on" are listeners. */
export const h = (tag, attributes, ...children) => fill(document.createElement(tag), attributes, children);

/** An SVG element. */
export const svg = (tag, attributes, ...children) =>
  fill(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);

/** A button that says by aria-pressed whether it is on. */
export function toggle(label, title, onclick) {
  const button = h('button', { type: 'button', class: 'em-button', 'aria-pressed': 'false', title, onclick }, label);
  return { button, set: (on) => button.setAttribute('aria-pressed', String(on)) };
}

/** One of several, as a row of buttons. @param choices  [value, label, title] each */
export function segments(label, choices, choose) {
  const buttons = new Map(choices.map(([value, text, title]) => [value, h('button', {
    type: 'button', class: 'em-button', 'aria-pressed': 'false', title, onclick: () => choose(value),
  }, text)]));
  return {
    element: h('div', { class: 'em-segments', role: 'group', 'aria-label': label }, ...buttons.values()),
    set(chosen) {
      for (const [value, button] of buttons) button.setAttribute('aria-pressed', String(value === chosen));
    },
  };
}

export function select(label, choices, choose) {
  const element = h('select', { 'aria-label': label, onchange: () => choose(element.value) },
    ...choices.map(([value, text]) => h('option', { value }, text)));
  return { element, set: (value) => { element.value = value; } };
}

export function slider(label, { min, max, step }, slide) {
  const element = h('input', {
    type: 'range', min, max, step, 'aria-label': label, oninput: () => slide(element.valueAsNumber),
  });
  return { element, set: (value) => { element.value = value; } };
}

/** A button that copies text, and says so. */
export function copyButton(label, text) {
  const button = h('button', { type: 'button', class: 'em-button' }, label);
  button.addEventListener('click', async () => {
    const done = await copy(text());
    button.textContent = done ? 'Copied' : 'Could not copy';
    setTimeout(() => { button.textContent = label; }, 1600);
  });
  return button;
}

async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    // Not offered for this page: the older way.
    const area = h('textarea', { class: 'em-offscreen', 'aria-hidden': 'true' });
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand('copy');
    area.remove();
    return done;
  }
}
