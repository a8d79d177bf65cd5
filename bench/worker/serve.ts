// Runs inside a worker, a process of its own.
import { writeSync } from 'node:fs'
import { createInterface } from 'node:readline'

const secondsUsed = () => {
  const { user, system } = process.cpuUsage()
  return (user + system) / 1e6
}

/**
 * Answers calls of `work`, one at a time. A line of standard input holds its arguments, a line of standard
 * output what it gives and the seconds of processor that the worker has had so far, both as JSON. The end of
 * the input ends the worker.
 */
export async function serve(work: (...args: never[]) => unknown) {
  for await (const line of createInterface({ input: process.stdin })) {
    const outcome = await work(...(JSON.parse(line) as never[]))
    writeSync(1, `${JSON.stringify({ seconds: secondsUsed(), outcome })}\n`)
  }
  // Left to itself, a process that has loaded a large WebAssembly module goes on compiling it for seconds.
  process.kill(process.pid, 'SIGKILL')
}
