// Scales, round tick marks and short texts of numbers.
//
// An axis is { range: [from, to], log, ticks, format }, as plot.js describes it.

export function scaled({ range: [a, b], log }, value) {
  return log ? Math.log(value / a) / Math.log(b / a) : (value - a) / (b - a);
}

export function unscaled({ range: [a, b], log }, u) {
  return log ? a * (b / a) ** u : a + u * (b - a);
}

/** Round numbers inside an axis, with their texts. */
export function ticks({ range: [a, b], log, ticks: given, format }, wanted) {
  let values = given;
  let text = format;
  if (!values && log) {
    const [low, high] = [Math.ceil(Math.log10(a) - 1e-9), Math.floor(Math.log10(b) + 1e-9)];
    const step = Math.max(1, Math.ceil((high - low) / wanted));
    values = [];
    for (let k = Math.ceil(low / step) * step; k <= high; k += step) values.push(10 ** k);
    text ??= (value) => `10${superscript(Math.round(Math.log10(value)))}`;
  } else if (!values) {
    const rough = (b - a) / wanted;
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].find((s) => s * power >= 0.7 * rough) * power;
    values = [];
    for (let k = Math.ceil(a / step - 1e-9); k <= Math.floor(b / step + 1e-9); k++) values.push(k * step);
    const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    text ??= (value) => value.toFixed(Math.min(decimals, 12)).replace(/^-(?=0(\.0*)?$)/, "").replace("-", "−");
  }
  text ??= (value) => String(value).replace("-", "−");
  return Array.from(values, (value) => ({ value, text: text(value) }));
}

export function superscript(integer) {
  const digits = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  return String(integer).replace(/\d/g, (d) => digits[d]).replace("-", "⁻");
}

/** A number as a reader likes it: 3e-8, 0.0123, 1.234. */
export function short(value, digits = 2) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (!Number.isFinite(size)) return "infinite";
  if (size >= 1e-3 && size < 1e4) return String(Number(value.toPrecision(digits))).replace("-", "−");
  return value.toExponential(Math.max(0, digits - 1)).replace("e+", "e").replace(/^-/, "−");
}
