import { execFile, spawn } from 'node:child_process'
import { rmSync } from 'node:fs'
import { dirname, join, resolve } from 'node:path'
import { createInterface } from 'node:readline'
import { fileURLToPath } from 'node:url'
import { promisify } from 'node:util'
import { rolldown } from 'rolldown'
import type { AtLeast, Cost, Job } from '../speed/job'

export const root = fileURLToPath(new URL('../..', import.meta.url)).replace(/\/$/, '')

/**
 * Bundles a script of this folder as Vite builds an app. `world` is a file that stands in for the solver's `world.ts`. Not with esbuild, which turns the constants of a bundle into variables:
 * the compiler then looks every one of them up, and a solver that names its offsets is half as slow again. What is imported late
 * stays a file of its own, or every process would load every engine.
 */
export async function bundle(script: string, world?: string) {
  const own = join(root, 'registry/gravity-stack/world')
  const dir = join(root, 'node_modules/.cache/gravity-stack-bench', `${script}-${process.pid}`)
  const built = await rolldown({
    input: join(root, `bench/worker/${script}.ts`),
    platform: 'node',
    external: /^[^./]/,
    plugins: [
      {
        name: 'another-world',
        resolveId: (id, importer) =>
          world && importer && resolve(dirname(importer), id) === own ? world : null,
      },
      {
        // Files named inside node_modules stay outside the bundle too: WebAssembly is loaded from beside them.
        name: 'keep-packages-outside',
        resolveId(id, importer) {
          if (!importer || !id.includes('node_modules')) return null
          return { id: resolve(dirname(importer), id), external: 'absolute' }
        },
      },
    ],
    logLevel: 'warn',
  })
  await built.write({
    dir,
    format: 'esm',
    entryFileNames: '[name].mjs',
    chunkFileNames: '[name].mjs',
    minify: { compress: true },
  })
  process.on('exit', () => rmSync(dir, { recursive: true, force: true }))
  return join(dir, `${script}.mjs`)
}

export type Outcome<J extends Job> = J extends { kind: 'errors' }
  ? number[][]
  : J extends { kind: 'scene cost' }
    ? (number | AtLeast)[]
    : J extends { kind: 'pour cost' }
      ? Cost | AtLeast
      : number

/**
 * What a script of this folder prints as JSON, for tests, in a process of its own: what a test runner does to modules makes the
 * solver ten times slower. It is ended after `seconds`.
 */
export async function printed<T>(script: string, seconds: number): Promise<T> {
  const options = { cwd: root, maxBuffer: 2 ** 24, timeout: 1000 * seconds }
  return JSON.parse((await promisify(execFile)(process.execPath, [await bundle(script)], options)).stdout)
}

/** Seconds of processor that jobs have taken in all. */
export const spent = { seconds: 0 }

/** How the line begins that a process ends a job with. */
const said = '{"seconds"'
/** ms after which a job that may take so many seconds of processor does not come back at all. */
const hung = (patience: number) => 1000 * (3 * patience + 30)

function parsed(line: string) {
  // JSON knows no Infinity: it writes null, and an error without bound is what that means here.
  const { outcome, seconds } = JSON.parse(line, (_, value) => value ?? Number.POSITIVE_INFINITY)
  return { outcome: outcome ?? null, seconds }
}

/**
 * The outcome of a job, or null when it took more than `patience` seconds of processor: however busy the machine is, the
 * same jobs are given up. One that doesn't come back at all is ended from here.
 */
export function runJob<J extends Job>(child: string, job: J, patience = 300): Promise<Outcome<J> | null> {
  const flags =
    job.kind === 'allocation' ? ['--expose-gc', '--min-semi-space-size=256', '--max-semi-space-size=256'] : []
  return new Promise((resolve, reject) => {
    const options = {
      cwd: root,
      encoding: 'utf8' as const,
      timeout: hung(patience),
      killSignal: 'SIGKILL' as const,
    }
    const args = [...flags, child, JSON.stringify(job), String(patience)]
    execFile(process.execPath, args, options, (error, out, err) => {
      // A job that has said its last line ends itself the hard way, which is no failure.
      const last = out.trimEnd().split('\n').at(-1) ?? ''
      if (!out.endsWith('\n') || !last.startsWith(said)) {
        if (!error?.killed) return reject(new Error(`${JSON.stringify(job)}\n${err || error?.message}`))
        spent.seconds += patience
        return resolve(null)
      }
      const { outcome, seconds } = parsed(last)
      spent.seconds += seconds
      resolve(outcome)
    })
  })
}

/** A process that takes the jobs of one engine in turns and waits in between, so that it warms up once. */
export function openTurns(child: string) {
  const player = spawn(process.execPath, [child, 'turns'], { cwd: root, stdio: 'pipe' })
  let before = 0
  let complaints = ''
  let onLine = (_line: string) => {}
  let onEnd = () => {}
  player.stderr.on('data', (text) => {
    complaints = `${complaints}${text}`.slice(-4000)
  })
  // Whoever has ended takes no more orders, which its end says already.
  player.stdin.on('error', () => {})
  player.on('close', () => onEnd())
  createInterface({ input: player.stdout }).on('line', (line) => onLine(line))
  return {
    /** The outcome of a job, or null when it did not come back. */
    take<J extends Job>(job: J, patience: number): Promise<Outcome<J> | null> {
      return new Promise((resolve, reject) => {
        const giveUp = setTimeout(() => {
          onEnd = () => {}
          player.kill('SIGKILL')
          resolve(null)
        }, hung(patience))
        onEnd = () => {
          clearTimeout(giveUp)
          reject(new Error(`${JSON.stringify(job)}\n${complaints}`))
        }
        onLine = (line) => {
          if (!line.startsWith(said)) return
          clearTimeout(giveUp)
          onEnd = () => {}
          const { outcome, seconds } = parsed(line)
          spent.seconds += seconds - before
          before = seconds
          resolve(outcome)
        }
        player.stdin.write(`${JSON.stringify(job)}\n`)
      })
    },
    close: () => player.stdin.end(),
  }
}
export type Turns = ReturnType<typeof openTurns>
