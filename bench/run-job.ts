import { execFile } from 'node:child_process'
import { mkdirSync, rmSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { build } from 'esbuild'
import type { AtLeast, Cost, Job } from './job'

export const root = dirname(dirname(fileURLToPath(import.meta.url)))

/** Bundles a script of this folder as an app would be: development loaders wrap functions, and that costs time. */
export async function bundle(script: string) {
  const folder = join(root, 'node_modules/.cache/gravity-stack-bench')
  mkdirSync(folder, { recursive: true })
  const outfile = join(folder, `${script}-${process.pid}.mjs`)
  await build({
    entryPoints: [join(root, `bench/${script}.ts`)],
    outfile,
    bundle: true,
    format: 'esm',
    platform: 'node',
    target: 'es2022',
    packages: 'external',
    plugins: [
      {
        // Files named inside node_modules stay outside the bundle too: WebAssembly is loaded from beside them.
        name: 'keep-packages-outside',
        setup(context) {
          context.onResolve({ filter: /node_modules/ }, (args) => ({
            path: join(args.resolveDir, args.path),
            external: true,
          }))
        },
      },
    ],
    logLevel: 'error',
  })
  process.on('exit', () => rmSync(outfile, { force: true }))
  return outfile
}

export type Outcome<J extends Job> = J extends { kind: 'errors' }
  ? number[][]
  : J extends { kind: 'scene cost' }
    ? number[]
    : J extends { kind: 'pour cost' }
      ? Cost | AtLeast
      : number

/** Seconds of processor that jobs have taken in all. */
export const spent = { seconds: 0 }

/** The outcome of a job, or null when it took longer than `limit` milliseconds. */
export function runJob<J extends Job>(child: string, job: J, limit = 300_000): Promise<Outcome<J> | null> {
  const flags =
    job.kind === 'allocation' ? ['--expose-gc', '--min-semi-space-size=256', '--max-semi-space-size=256'] : []
  return new Promise((resolve, reject) => {
    const options = { cwd: root, encoding: 'utf8' as const, timeout: limit, killSignal: 'SIGKILL' as const }
    execFile(process.execPath, [...flags, child, JSON.stringify(job)], options, (error, out, err) => {
      if (error?.killed) {
        spent.seconds += limit / 1000
        return resolve(null)
      }
      if (error) return reject(new Error(`${JSON.stringify(job)}\n${err}`))
      // JSON knows no Infinity: it writes null, and an error without bound is what that means here.
      const last = out.trimEnd().split('\n').at(-1) ?? ''
      const { outcome, seconds } = JSON.parse(last, (_, value) => value ?? Number.POSITIVE_INFINITY)
      spent.seconds += seconds
      resolve(outcome)
    })
  })
}
