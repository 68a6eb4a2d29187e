import type { Overview } from "./solver";

/** Whether there is no course in time: of a spectrum, or of all records of a suite together. */
export const isStill = ({ spectral, suite }: Overview) => spectral || suite?.record === 0;
