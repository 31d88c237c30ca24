/** A page with a part that a test writes, between a line `<!-- made by … -->` and a line `<!-- end -->`. */
export function withMarkedPart(page: string, part: string): string {
  const [start] = /^<!-- made by .*-->$/m.exec(page) ?? [''];
  const [from, to] = [page.indexOf(start) + start.length, page.indexOf('<!-- end -->')];
  if (start === '' || to < from) throw new Error('The page has lost the marks between which a test writes.');
  return `${page.slice(0, from)}\n${part}\n${page.slice(to)}`;
}
