/**
 * A table with one line of names; names with a comma or a quotation mark are quoted.
 * @param columns at least one, all as long as the first; numbers have a decimal point
 */
export function csvOf(names: readonly string[], columns: readonly ArrayLike<number>[]): string {
  const head = names.map((name) => (/[",]/.test(name) ? `"${name.replaceAll('"', '""')}"` : name)).join();
  const rows = Array.from(columns[0], (_, row) => columns.map((column) => column[row]).join());
  return `${[head, ...rows].join('\n')}\n`;
}

/** Lets the browser save a text as a file. */
export function saveText(name: string, text: string, type: string): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  // The browser reads the address after the click.
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
