// A title says what its writer knew: the width of a gap that has been changed since is no longer said.
const METRES = { mm: 1e-3, cm: 1e-2, m: 1, in: 0.0254, ft: 0.3048 } as const;
const LENGTH = String.raw`\d+(?:[.,]\d+)?\s?(?:mm|cm|m|in|ft)\b`;
const LENGTHS = `${LENGTH}(?:(?: and| dan| &| \\|) ${LENGTH})*`;
const AFTER = String.raw`(?:(?:with|dengan) )?(?:an? )?(?:gaps?|separation|joint|celah)(?: width)?(?: of|:| =| selebar| sebesar)? ${LENGTHS}`;
const BEFORE = String.raw`${LENGTHS} (?:apart|(?:wide )?(?:gaps?|separation|joint))\b`;
const SAID = new RegExp(String.raw`[\s,;:–—-]*\(?\b(?:${AFTER}|${BEFORE})\)?`, "gi");

/** The title without gaps that have none of the widths [m] that are said, as far as digits say them. */
export function trueTitle(title: string, widths: number[]): string {
  return title.replace(SAID, (said) => {
    const all = [...said.matchAll(/(\d+)(?:[.,](\d+))?\s?(mm|cm|m|in|ft)\b/g)];
    const isTrue = all.every(([, whole, part = "", unit]) => widths.some((width) =>
      Math.abs(width / METRES[unit as "m"] - Number(`${whole}.${part}`)) <= 0.5 * 10 ** -part.length * (1 + 1e-9)));
    return isTrue ? said : "";
  }).replace(/^[\s,;:–—-]+/, "");
}
