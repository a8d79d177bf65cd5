/**
 * Makes every number and array inside `to` what it is inside `from`. Joints stay apart: whoever grabbed
 * shares them.
 */
export function copy(from: object, to: object): void {
  const target = to as Record<string, unknown>
  for (const [name, value] of Object.entries(from)) {
    if (name === 'joints') continue
    const own = target[name]
    if (typeof value !== 'object') target[name] = value
    else if (Array.isArray(value)) target[name] = [...value]
    else if (!ArrayBuffer.isView(value)) copy(value as object, own as object)
    else if ((own as Float64Array).length === (value as Float64Array).length)
      (own as Float64Array).set(value as Float64Array)
    else target[name] = (value as Float64Array).slice()
  }
}
