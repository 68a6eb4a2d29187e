// Every word of the page that is no key of a case, in English and Indonesian. {name} is filled in.
import { signal } from "@preact/signals";

const en = {
  lead: "Buildings side by side in an earthquake: drag the gap and see whether, where and how hard they collide.",
  cases: "Cases", "case.frames": "Eight and six storeys", "case.monograph": "Monograph's pair", "case.columns": "Floors that do not meet",
  "case.row": "Row of three", "case.moat": "Isolated in a moat", "case.yielding": "Yielding pair", "case.plan": "Twisting pair, in plan",
  "gap.of": "Gap {name}", "gap.given": "given", "gap.which": "Gap that the slider is of", "gap.moves": "Moves {names}.", "gap.moves.many": "Moves the {n} buildings beyond it.", "gap.clearance": "Beyond {width} the clearance of the plan grows too.", "gap.met": "It ends at {width}: there they would meet {name}, which stays.", solving: "Simulating …", "solving.figures": "The verdict stands; histories and figures are still being simulated …", "curve.runs": "What other widths of the gap would give is still being simulated: {percent} %", cancel: "Cancel", stale: "Results of “{name}” as it was computed before, not of the case that stands here now.", rough: "Drawn from coarse samples, since the run that the case asks for could not be made (see the error); peaks and impacts are exact.", "take.stale": "These would be of “{name}”, not of the case that stands here now.", undo: "Undo", redo: "Redo", anew: "Start anew", "solved.in": "Simulated in {ms} ms",
  "verdict.remark": "Remarks", "verdict.gaps": "{n} gaps more", "verdict.gap": "One gap more", "verdict.all": "All {n} gaps:",
  motion: "In motion", "motion.none": "A spectrum has no course in time: nothing moves, and no impact is counted. What it gives is the gap that each level needs, as bentur gap computes it. A record or a harmonic motion sets the buildings in motion.", tables: "In numbers", figures: "Figures", "figures.more": "More figures, as files", "figures.wrong": "No figure: the case has errors.", "figures.rough": "No figure: the run that the case asks for could not be made.", "figures.drawing": "It is being drawn …", impacts: "Impacts", edit: "The case", take: "Take away",
  "motion.play": "Play", "motion.previous": "Previous impact", "motion.next": "Next impact", "motion.hardest": "Hardest impact", "motion.speed": "Speed",
  "motion.slow": "Slow at impacts", "motion.magnify": "Magnification", "motion.picture": "The buildings in motion, to scale, displacements magnified", "motion.timeline": "Roof displacements over time, impacts as ticks",
  "history.opening": "Opening", "history.point": "Level", "history.hardest": "hit hardest", "history.all": "All of the time", "history.hint": "Drag across to zoom, double-click for all; a click moves the buildings to that time.", time: "Time",
  "impact.none": "No impact.", "impact.hardest": "{n} of {all} impacts, the hardest", "impact.first": "{n} of {all} impacts, the first in this order", "impact.whole": "Show {n}", "impact.more": "The first {n} of {all} in this order.", "impact.cut": "Only the hardest {n} are sorted here; the CSV has all.", "impact.show": "Show impact {n}",
  "curve.force": "Peak force", "curve.amplification": "Amplification", "curve.note": "Peak contact force, and the largest displacement over that without contact, simulated at every gap.", "curve.progress": "{percent} % of the curve",
  "edit.form": "Form", "edit.text": "Case file", "edit.label": "Case file (TOML)", "errors.at": "Line {line}, column {column}", errors: "Errors", "errors.see": "To the errors: {n}",
  "form.add": "Add a neighbour known by little", "form.harmonic": "Harmonic ground motion", "form.elcentro": "El Centro 1940", "form.record": "Record file …", "form.none": "The form comes back when the text is valid TOML.", "form.more": "{n} more numbers: edit them in the case file.", "form.link": "Link {n}", "form.bays": "Bays", "form.more.of": "{what}: one more, {name}", "form.fewer.of": "{what}: one fewer, {name}",
  open: "Open …", "take.summary": "Summary (JSON)", "take.impacts": "Impacts (CSV)", "take.histories": "Histories (CSV)", "take.gaps": "Gaps needed (JSON)", "take.modes": "Modes (JSON)", "take.report": "Report (HTML)", "take.svg": "Picture (SVG)", "take.png": "Picture (PNG)", "take.link": "Link with this case", "take.linked": "The link is in the address bar and, where the browser allows it, on the clipboard.", "take.link.record": "The link has no room for your record file; send it along.", "take.note": "Nothing leaves this page: no server, no request.",
  "suite.all": "all {n}, in short", "suite.still": "Choose a record to see the buildings move under it.", "suite.hardest": "Under record {name}, whose impact is the hardest of all: choose another one above.", "suite.closest": "Under record {name}, which brings them closest: choose another one above.",
  pin: "Pin this variant", unpin: "Unpin", pinned: "Pinned variant", now: "Now", compare: "Side by side", variant: "Variant", "compare.needed": "Gap needed",
  language: "Language", theme: "Theme", "theme.auto": "Auto", "theme.light": "Light", "theme.dark": "Dark", drop: "Drop a case or a record file",
  "error.cancelled": "Cancelled.", "error.limit": "Given up after 20 seconds: this is more than a page should do. bentur run takes as long as you let it.", "error.worker": "The solver ran out of memory or stopped. bentur run has more.", "error.file": "{name} is larger than {size} MiB.", "error.lines": "The text has more than {n} lines, which is more than an editor shows.", "error.unkept": "{name} was too large to be kept over a reload: open it again.", "error.link": "The link's case cannot be read.",
  "error.text": "The case is longer than 1 MiB, which is more than a page reads.",
  "error.buildings": "The case has {n} buildings, over the limit of {most} of a page; bentur run takes more.",
  "error.elevations": "Building “{name}” has {n} elevations, over the limit of {most} of a page; bentur run takes more.",
  "error.joints": "Building “{name}” has {n} sways and rotations, over the limit of {most} of a page; bentur run takes more.",
  "error.modes": "The buildings have {n} modes together, “{name}” {of} of them, over the limit of {most} of a page; bentur run takes more.",
  "error.memory": "There is not enough memory for this case in a browser; bentur run has more.",
  "error.steps": "A run takes {n} steps or more, over the limit of {most} of a page. Is a motion so fast meant? bentur run may take longer.",
  "error.memory.run": "A run takes {n} MB of memory, over the limit of a page. Make the duration shorter, or take bentur run.",
  skip: "To the results", footer: "bentur {version}: the solver of the command line, compiled to WebAssembly.",
} as const;

const id: Record<keyof typeof en, string> = {
  lead: "Gedung bersebelahan dalam gempa: geser celahnya dan lihat apakah, di mana dan sekeras apa mereka berbenturan.",
  cases: "Kasus", "case.frames": "Delapan dan enam lantai", "case.monograph": "Pasangan dalam monografi", "case.columns": "Lantai tidak sejajar",
  "case.row": "Tiga sederet", "case.moat": "Terisolasi dalam parit", "case.yielding": "Pasangan leleh", "case.plan": "Pasangan memuntir, denah",
  "gap.of": "Celah {name}", "gap.given": "tersedia", "gap.which": "Celah milik penggeser", "gap.moves": "Menggeser {names}.", "gap.moves.many": "Menggeser {n} bangunan di baliknya.", "gap.clearance": "Di atas {width} jarak batas denah ikut membesar.", "gap.met": "Berakhir pada {width}: di situ {name}, yang tetap di tempatnya, akan tersentuh.", solving: "Menghitung …", "solving.figures": "Kesimpulan sudah ada; riwayat dan gambar masih dihitung …", "curve.runs": "Hasil untuk lebar celah lain masih dihitung: {percent} %", cancel: "Batal", stale: "Hasil “{name}” dari hitungan sebelumnya, bukan dari kasus yang sekarang tertulis.", rough: "Digambar dari cuplikan yang kasar, karena hitungan yang diminta kasus ini tidak dapat dijalankan (lihat kesalahannya); puncak dan tumbukan tetap eksak.", "take.stale": "Ini milik “{name}”, bukan kasus yang sekarang tertulis.", undo: "Batalkan perubahan", redo: "Ulangi perubahan", anew: "Mulai dari awal", "solved.in": "Dihitung dalam {ms} ms",
  "verdict.remark": "Catatan", "verdict.gaps": "{n} celah lagi", "verdict.gap": "Satu celah lagi", "verdict.all": "Semua {n} celah:",
  motion: "Gerakan", "motion.none": "Spektrum tidak punya riwayat waktu: tidak ada yang bergerak, dan tidak ada benturan yang dihitung. Yang diberikannya ialah celah yang diperlukan setiap elevasi, seperti dihitung bentur gap. Rekaman atau gerakan harmonik menggerakkan gedung.", tables: "Dalam angka", figures: "Gambar", "figures.more": "Gambar lain, sebagai berkas", "figures.wrong": "Tidak ada gambar: kasusnya memuat kesalahan.", "figures.rough": "Tidak ada gambar: hitungan yang diminta kasus ini tidak dapat dijalankan.", "figures.drawing": "Sedang digambar …", impacts: "Benturan", edit: "Kasus", take: "Simpan",
  "motion.play": "Putar", "motion.previous": "Benturan sebelumnya", "motion.next": "Benturan berikutnya", "motion.hardest": "Benturan terkeras", "motion.speed": "Kecepatan",
  "motion.slow": "Lambat saat benturan", "motion.magnify": "Pembesaran", "motion.picture": "Gedung bergerak, sesuai skala, perpindahan diperbesar", "motion.timeline": "Perpindahan atap terhadap waktu, benturan sebagai garis",
  "history.opening": "Bukaan", "history.point": "Elevasi", "history.hardest": "yang terkeras", "history.all": "Seluruh waktu", "history.hint": "Seret untuk memperbesar, klik ganda untuk semua; klik memindahkan gedung ke waktu itu.", time: "Waktu",
  "impact.none": "Tidak ada benturan.", "impact.hardest": "{n} dari {all} benturan, yang terkeras", "impact.first": "{n} dari {all} benturan, yang pertama menurut urutan ini", "impact.whole": "Tampilkan {n}", "impact.more": "{n} pertama dari {all} menurut urutan ini.", "impact.cut": "Hanya {n} yang terkeras diurutkan di sini; CSV memuat semuanya.", "impact.show": "Tunjukkan benturan {n}",
  "curve.force": "Gaya puncak", "curve.amplification": "Amplifikasi", "curve.note": "Gaya kontak puncak, dan perpindahan terbesar dibagi perpindahan tanpa kontak, dihitung pada setiap celah.", "curve.progress": "{percent} % dari kurva",
  "edit.form": "Formulir", "edit.text": "Berkas kasus", "edit.label": "Berkas kasus (TOML)", "errors.at": "Baris {line}, kolom {column}", errors: "Kesalahan", "errors.see": "Ke kesalahan: {n}",
  "form.add": "Tambah tetangga yang sedikit diketahui", "form.harmonic": "Gerakan tanah harmonik", "form.elcentro": "El Centro 1940", "form.record": "Berkas rekaman …", "form.none": "Formulir kembali bila teksnya TOML yang sah.", "form.more": "{n} angka lagi: ubah dalam berkas kasus.", "form.link": "Penghubung {n}", "form.bays": "Bentang", "form.more.of": "{what}: tambah satu, {name}", "form.fewer.of": "{what}: kurangi satu, {name}",
  open: "Buka …", "take.summary": "Ringkasan (JSON)", "take.impacts": "Benturan (CSV)", "take.histories": "Riwayat (CSV)", "take.gaps": "Celah perlu (JSON)", "take.modes": "Ragam (JSON)", "take.report": "Laporan (HTML)", "take.svg": "Gambar (SVG)", "take.png": "Gambar (PNG)", "take.link": "Tautan dengan kasus ini", "take.linked": "Tautannya ada di bilah alamat dan, bila peramban mengizinkan, di papan klip.", "take.link.record": "Tautan tidak memuat berkas rekaman Anda; kirimkan juga.", "take.note": "Tidak ada yang meninggalkan halaman ini: tanpa server, tanpa permintaan.",
  "suite.all": "semua {n}, ringkas", "suite.still": "Pilih satu rekaman untuk melihat gedung bergerak olehnya.", "suite.hardest": "Oleh rekaman {name}, dengan tumbukan terkeras dari semuanya: pilih yang lain di atas.", "suite.closest": "Oleh rekaman {name}, yang paling mendekatkan mereka: pilih yang lain di atas.",
  pin: "Sematkan varian ini", unpin: "Lepaskan", pinned: "Varian tersemat", now: "Sekarang", compare: "Berdampingan", variant: "Varian", "compare.needed": "Celah perlu",
  language: "Bahasa", theme: "Tema", "theme.auto": "Otomatis", "theme.light": "Terang", "theme.dark": "Gelap", drop: "Jatuhkan kasus atau rekaman",
  "error.cancelled": "Dibatalkan.", "error.limit": "Dihentikan setelah 20 detik: lebih dari yang patut bagi sebuah halaman. bentur run boleh selama yang Anda mau.", "error.worker": "Penghitung kehabisan memori atau berhenti. bentur run punya lebih banyak.", "error.file": "{name} lebih besar dari {size} MiB.", "error.lines": "Teksnya lebih dari {n} baris, lebih dari yang dapat ditampilkan penyunting.", "error.unkept": "{name} terlalu besar untuk disimpan saat halaman dimuat ulang: buka lagi.", "error.link": "Kasus dalam tautan tidak terbaca.",
  "error.text": "Kasusnya lebih dari 1 MiB, lebih dari yang dibaca sebuah halaman.",
  "error.buildings": "Kasusnya punya {n} gedung, melebihi batas {most} bagi sebuah halaman; bentur run sanggup lebih banyak.",
  "error.elevations": "Gedung “{name}” punya {n} elevasi, melebihi batas {most} bagi sebuah halaman; bentur run sanggup lebih banyak.",
  "error.joints": "Gedung “{name}” punya {n} goyangan dan rotasi, melebihi batas {most} bagi sebuah halaman; bentur run sanggup lebih banyak.",
  "error.modes": "Semua gedung punya {n} ragam, {of} di antaranya pada “{name}”, melebihi batas {most} bagi sebuah halaman; bentur run sanggup lebih banyak.",
  "error.memory": "Memori peramban tidak cukup untuk kasus ini; bentur run punya lebih banyak.",
  "error.steps": "Hitungannya perlu {n} langkah atau lebih, melebihi batas {most} bagi sebuah halaman. Memang dimaksud gerakan secepat itu? bentur run boleh lebih lama.",
  "error.memory.run": "Hitungannya perlu memori {n} MB, melebihi batas sebuah halaman. Perpendek durasinya, atau pakai bentur run.",
  skip: "Ke hasil", footer: "bentur {version}: penghitung dari baris perintah, dikompilasi ke WebAssembly.",
};

export type Word = keyof typeof en;
export const hasWord = (word: string): word is Word => word in en;
export const languages = { en: "English", id: "Bahasa Indonesia" } as const;
export const language = signal<keyof typeof languages>(navigator.language.toLowerCase().startsWith("id") ? "id" : "en");
export function say(word: Word, values: Record<string, string | number> = {}): string {
  const text: string = (language.value === "id" ? id : en)[word];
  return text.replace(/\{(\w+)\}/g, (whole, name: string) => (name in values ? String(values[name]) : whole));
}
const RAISED = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" } as Record<string, string>;
const FROM_RAISED = Object.fromEntries(Object.entries(RAISED).map(([digit, raised]) => [raised, digit]));
/** What a number is that is written so; not one where it is none. */
export function valueOf(written: string): number {
  const [digits, power = "⁰"] = written.replace("−", "-").split(/\s×\s10/);
  return Number(digits) * 10 ** Number([...power].map((one) => FROM_RAISED[one]).join(""));
}
/** Four significant digits, as everywhere in bentur: "−0.01995", "1.234 × 10⁻⁸". */
export function number(value: number | null | undefined): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size === 0) return "0";
  const sign = value < 0 ? "−" : "";
  if (size < 1e-4 || size >= 1e7) {
    const [digits, power] = size.toExponential(3).split("e");
    return `${sign}${digits} × 10${[...String(Number(power))].map((one) => RAISED[one]).join("")}`;
  }
  return sign + String(Number(size.toFixed(Math.min(7, Math.max(0, 3 - Math.floor(Math.log10(size)))))));
}
