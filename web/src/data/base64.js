// SPDX-License-Identifier: MIT

/** The bytes that base64 text stands for; white space is skipped. */
export function bytesFromBase64(text) {
  try {
    if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
    const binary = atob(text);
    const bytes = new Uint8Array(binary.length);
    for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
    return bytes;
  } catch {
    throw new Error('the mesh data are not valid base64');
  }
}
