// The one kind of process in which the benchmark measures and plays: it holds one bundled function and
// answers calls of it. A process of its own has no other engine's compiled code. What a test runner does to
// modules makes the solver ten times slower.
import { spawn } from 'node:child_process'
import { createInterface } from 'node:readline'
import { bundleWorker } from '../build/bundle'
import { root } from '../build/root'

/** How the line begins that answers a call. What a package prints besides is passed over. */
const answer = '{"seconds"'

export type Answer<T> = { outcome: T; seconds: number }
type Options = {
  /** flags of Node, and arguments that the worker finds in `process.argv` */
  flags?: string[]
  args?: string[]
  /** JSON has no Infinity and writes null: true reads each null as a figure without bound. */
  unbounded?: boolean
}

/** Starts a worker of a file that `bundleWorker` has made. */
export function openWorker(file: string, { flags = [], args = [], unbounded = false }: Options = {}) {
  const child = spawn(process.execPath, [...flags, file, ...args], { cwd: root, stdio: 'pipe' })
  let complaints = ''
  let onLine = (_line: string) => {}
  let onEnd = () => {}
  child.stderr.on('data', (text) => {
    complaints = `${complaints}${text}`.slice(-4000)
  })
  // A worker that has ended takes no more calls, which its end says already.
  child.stdin.on('error', () => {})
  child.on('close', () => onEnd())
  createInterface({ input: child.stdout }).on('line', (line) => onLine(line))
  const parse = (line: string) =>
    JSON.parse(line, unbounded ? (_, value) => value ?? Number.POSITIVE_INFINITY : undefined)
  return {
    /**
     * Calls the function. Returns null and ends the worker after `limit` ms. Rejects if the worker ends
     * itself.
     */
    call<T>(args: unknown[], limit: number): Promise<Answer<T> | null> {
      return new Promise((resolve, reject) => {
        const settle = () => {
          clearTimeout(giveUp)
          onLine = () => {}
          onEnd = () => {}
        }
        const giveUp = setTimeout(() => {
          settle()
          child.kill('SIGKILL')
          resolve(null)
        }, limit)
        onEnd = () => {
          settle()
          reject(new Error(`${JSON.stringify(args)}\n${complaints}`))
        }
        onLine = (line) => {
          if (!line.startsWith(answer)) return
          settle()
          resolve(parse(line))
        }
        child.stdin.write(`${JSON.stringify(args)}\n`)
      })
    },
    /** Ends the worker once it has answered. */
    close: () => child.stdin.end(),
  }
}

export type Worker = ReturnType<typeof openWorker>

/** One call of a module's function in a worker of its own, which is given up after `seconds`. */
export async function callInWorker<T>(
  module: string,
  name: string,
  args: unknown[],
  seconds: number,
): Promise<T> {
  const worker = openWorker(await bundleWorker(module, name))
  const answer = await worker.call<T>(args, 1000 * seconds)
  worker.close()
  if (!answer) throw new Error(`${name} has not answered for ${seconds} s`)
  return answer.outcome
}
