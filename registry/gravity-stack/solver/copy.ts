/**
 * Makes every number and array inside `to` what it is inside `from`. Joints stay apart: whoever grabbed
 * shares them.
 */
export function copy(from: object, to: object): void {
  const target = to as Record<string, unknown>
  for (const [name, value] of Object.entries(from)) {
    if (name === 'joints') continue
    if (typeof value !== 'object') target[name] = value
    else if ('slice' in value) target[name] = value.slice()
    else copy(value, target[name] as object)
  }
}
