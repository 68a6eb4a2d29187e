// A case within a link: deflated, in the characters that an address may have.
import { signal } from "@preact/signals";

/** The text of the page's address, until it is changed. */
export const linked = signal<string | null>(null);

async function through(bytes: Uint8Array, stream: CompressionStream | DecompressionStream, most: number): Promise<Uint8Array> {
  let size = 0;
  const limit = new TransformStream<Uint8Array, Uint8Array>({ transform(part, out) {
    size += part.length;
    if (size > most) throw new Error("too long");
    out.enqueue(part);
  } });
  const read = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream().pipeThrough(stream).pipeThrough(limit);
  return new Uint8Array(await new Response(read as ReadableStream<Uint8Array<ArrayBuffer>>).arrayBuffer());
}

export async function toFragment(text: string): Promise<string> {
  const bytes = await through(new TextEncoder().encode(text), new CompressionStream("deflate-raw"), 1 << 20);
  let letters = "";
  for (const byte of bytes) letters += String.fromCharCode(byte);
  return `#case=${btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

/** @throws where the fragment is no case; nothing where it has none. */
export async function fromFragment(fragment: string): Promise<string | null> {
  const match = /^#case=([\w-]+)$/.exec(fragment);
  if (!match) {
    if (fragment.startsWith("#case=")) throw new Error("no case");
    return null;
  }
  const bytes = Uint8Array.from(atob(match[1].replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
  return new TextDecoder("utf-8", { fatal: true }).decode(await through(bytes, new DecompressionStream("deflate-raw"), 1 << 20));
}
