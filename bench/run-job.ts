import { execFile } from 'node:child_process'
import { rmSync } from 'node:fs'
import { dirname, join, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { rolldown } from 'rolldown'
import type { AtLeast, Cost, Job } from './job'

export const root = dirname(dirname(fileURLToPath(import.meta.url)))

/**
 * Bundles a script of this folder as Vite builds an app. Not with esbuild, which turns the constants of a bundle into variables:
 * the compiler then looks every one of them up, and a solver that names its offsets is half as slow again. What is imported late
 * stays a file of its own, or every process would load every engine.
 */
export async function bundle(script: string) {
  const dir = join(root, 'node_modules/.cache/gravity-stack-bench', `${script}-${process.pid}`)
  const built = await rolldown({
    input: join(root, `bench/${script}.ts`),
    platform: 'node',
    external: /^[^./]/,
    plugins: [
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
    ? number[]
    : J extends { kind: 'pour cost' }
      ? Cost | AtLeast
      : number

/** Seconds of processor that jobs have taken in all. */
export const spent = { seconds: 0 }

/**
 * The outcome of a job, or null when it took more than `patience` seconds of processor: however busy the machine is, the
 * same jobs are given up. One that doesn't come back at all is ended from here.
 */
export function runJob<J extends Job>(child: string, job: J, patience = 300): Promise<Outcome<J> | null> {
  const flags =
    job.kind === 'allocation' ? ['--expose-gc', '--min-semi-space-size=256', '--max-semi-space-size=256'] : []
  const hung = 1000 * (3 * patience + 30)
  return new Promise((resolve, reject) => {
    const options = { cwd: root, encoding: 'utf8' as const, timeout: hung, killSignal: 'SIGKILL' as const }
    const args = [...flags, child, JSON.stringify(job), String(patience)]
    execFile(process.execPath, args, options, (error, out, err) => {
      // A job that has said its last line ends itself the hard way, which is no failure.
      const last = out.endsWith('\n') ? out.trimEnd().split('\n').at(-1) : undefined
      if (!last?.startsWith('{"seconds"')) {
        if (!error?.killed) return reject(new Error(`${JSON.stringify(job)}\n${err || error?.message}`))
        spent.seconds += patience
        return resolve(null)
      }
      // JSON knows no Infinity: it writes null, and an error without bound is what that means here.
      const { outcome, seconds } = JSON.parse(last, (_, value) => value ?? Number.POSITIVE_INFINITY)
      spent.seconds += seconds
      resolve(outcome ?? null)
    })
  })
}
