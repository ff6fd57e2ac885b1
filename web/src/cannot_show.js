// SPDX-License-Identifier: MIT

/** Why the page cannot be shown, in words for its reader. */
export class CannotShow extends Error {}
