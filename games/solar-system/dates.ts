/** Dates of the Gregorian calendar as Julian dates, which count days. */

/** Midnight at the beginning of a day. Fliegel and Van Flandern, Comm. ACM 11, 657 (1968). */
export function julianDate(year: number, month: number, day: number): number {
  const a = Math.floor((14 - month) / 12);
  const y = year + 4800 - a;
  const m = month + 12 * a - 3;
  const days = day + Math.floor((153 * m + 2) / 5) + 365 * y + Math.floor(y / 4) - Math.floor(y / 100);
  return days + Math.floor(y / 400) - 32045.5;
}

/** The day of a Julian date, such as 2012-07-04. */
export function dayText(date: number): string {
  const [year, month, day] = calendarDay(date);
  return `${String(year).padStart(4, '0')}-${two(month)}-${two(day)}`;
}

/** The time of day of a Julian date, such as 18:05. */
export function timeText(date: number): string {
  const minutes = Math.floor((date + 0.5 - Math.floor(date + 0.5)) * 1440 + 1e-6);
  return `${two(Math.floor(minutes / 60))}:${two(minutes % 60)}`;
}

/** The Julian date of a text such as 2012-07-04; undefined where there is no such day. */
export function readDay(text: string): number | undefined {
  const [, year, month, day] = /^(\d{4})-(\d\d)-(\d\d)$/.exec(text) ?? [];
  if (year === undefined) return undefined;
  const date = julianDate(Number(year), Number(month), Number(day));
  return dayText(date) === text ? date : undefined;
}

const two = (value: number) => String(value).padStart(2, '0');

function calendarDay(date: number): [number, number, number] {
  // Half a second before midnight belongs to the next day, as rounding of the time may have caused it.
  const days = Math.floor(date + 0.5 + 0.5 / 86400);
  const a = days + 32044;
  const b = Math.floor((4 * a + 3) / 146097);
  const c = a - Math.floor((146097 * b) / 4);
  const d = Math.floor((4 * c + 3) / 1461);
  const e = c - Math.floor((1461 * d) / 4);
  const m = Math.floor((5 * e + 2) / 153);
  const day = e - Math.floor((153 * m + 2) / 5) + 1;
  return [100 * b + d - 4800 + Math.floor(m / 10), m + 3 - 12 * Math.floor(m / 10), day];
}
