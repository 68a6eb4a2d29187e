import { computed, effect, signal } from "@preact/signals";

const system = matchMedia("(prefers-color-scheme: dark)");
export const choice = signal<"auto" | "light" | "dark">("auto");
const dark = signal(system.matches);
system.addEventListener("change", () => { dark.value = system.matches; });
export const theme = computed(() => (choice.value === "auto" ? (dark.value ? "dark" : "light") : choice.value));
effect(() => { document.documentElement.dataset.theme = theme.value; });

const narrow = matchMedia("(max-width: 40rem)");
export const onTelephone = signal(narrow.matches);
narrow.addEventListener("change", () => { onTelephone.value = narrow.matches; });
