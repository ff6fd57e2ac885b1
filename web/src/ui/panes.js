// SPDX-License-Identifier: MIT

const rect = (x, y, width, height) => ({ x, y, width, height });

/**
 * Which pictures are on the canvas: where, of which points, under what name.
 *
 * @param size     {width, height} of the canvas in CSS pixels
 * @param current  {from, to, mixing, progress, label}: the state that the scrub slider has chosen
 * @param before   likewise, of the state before
 */
export function makePanes({ mode, wipe }, { width, height }, before, current) {
  const all = rect(0, 0, width, height);
  if (mode === 'single') return [{ ...current, viewport: all, scissor: all }];
  if (mode === 'wipe') {
    const x = Math.round(wipe * width);
    return [
      { ...before, viewport: all, scissor: rect(0, 0, x, height) },
      { ...current, viewport: all, scissor: rect(x, 0, width - x, height) },
    ];
  }
  const [one, two] = width >= height
    ? [rect(0, 0, Math.floor(width / 2) - 1, height), rect(Math.floor(width / 2) + 1, 0, Math.ceil(width / 2) - 1, height)]
    : [rect(0, 0, width, Math.floor(height / 2) - 1), rect(0, Math.floor(height / 2) + 1, width, Math.ceil(height / 2) - 1)];
  return [
    { ...before, viewport: one, scissor: one },
    { ...current, viewport: two, scissor: two },
  ];
}

/** Aspect of each picture. */
export function paneAspect({ mode }, { width, height }) {
  if (mode !== 'side') return width / height;
  return width >= height ? width / 2 / height : width / (height / 2);
}

export const inside = ({ x, y, width, height }, px, py) => px >= x && px < x + width && py >= y && py < y + height;

/** The picture at a place of the canvas. */
export const paneAt = (panes, x, y) => panes.find(({ scissor }) => inside(scissor, x, y)) ?? panes.at(-1);
