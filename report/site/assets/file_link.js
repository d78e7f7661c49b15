// A problem's file, and the state of its player, as the part of an address after #, and back. The input is
// untrusted.
//   #file=z.H4sIAA...&row=spring/Runge-Kutta%204/double/0.0167     packed; #file=t.title%20... as it is

(function (oddity) {
  'use strict';

  const longest = 100000;     // characters of a file
  const longestLink = 200000;

  class Unreadable extends Error {}

  async function through(bytes, stream, most) {
    const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
    const parts = [];
    let size = 0;
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
      size += part.value.length;
      if (size > most) {
        reader.cancel().catch(() => {});
        throw new Unreadable('The link has a file that is too long.');
      }
      parts.push(part.value);
    }
    return new Uint8Array(await new Blob(parts).arrayBuffer());
  }

  function letters(bytes) {
    let text = '';
    for (const byte of bytes) text += String.fromCharCode(byte);
    return btoa(text).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
  }

  function bytesOf(text) {
    if (!/^[A-Za-z0-9_-]*$/.test(text)) throw new Unreadable('The link is damaged.');
    return Uint8Array.from(atob(text.replace(/-/g, '+').replace(/_/g, '/')), (c) => c.charCodeAt(0));
  }

  async function unpacked(text) {
    const [kind, ...rest] = text.split('.');
    const all = rest.join('.');
    if (kind === 't') return decodeURIComponent(all);
    if (kind !== 'z') throw new Unreadable('The link has no file that the page can read.');
    const bytes = await through(bytesOf(all), new DecompressionStream('gzip'), 4 * longest);
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  }

  oddity.fileLink = {
    /** `play` is a player's own link, which gives everything except the file. Null where it would be too long. */
    async format(text, play) {
      const packed = window.CompressionStream
        ? 'z.' + letters(await through(new TextEncoder().encode(text), new CompressionStream('gzip'), Infinity))
        : 't.' + encodeURIComponent(text);
      const hash = `#file=${packed}${play.slice('#play'.length)}`;
      return text.length > longest || hash.length > longestLink ? null : hash;
    },

    /** Resolves to {text, play}, or {problem: a sentence}; to null if it is no such link. */
    async parse(hash) {
      if (!hash.startsWith('#file=')) return null;
      try {
        if (hash.length > longestLink) throw new Unreadable('The link is too long.');
        const [file, ...rest] = hash.slice('#file='.length).split('&');
        const text = await unpacked(file);
        if (text.length > longest) throw new Unreadable('The link has a file that is too long.');
        return { text, play: rest.length ? `#play&${rest.join('&')}` : '' };
      } catch (error) {
        return { problem: error instanceof Unreadable ? error.message : 'The link is damaged.' };
      }
    },
  };
})(window.oddity = window.oddity || {});
