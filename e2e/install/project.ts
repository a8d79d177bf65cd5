import { execFile, spawn } from 'node:child_process'
import { once } from 'node:events'
import { existsSync } from 'node:fs'
import { mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { delimiter, dirname, join } from 'node:path'
import { test as base, expect, type Page } from '@playwright/test'
import { root } from '../../scripts/run.mjs'
import { siteUrl } from '../../site.config.mjs'
import { freePort } from '../free-port'

/** What ours is called on the registry that the site serves. */
export const item = (name: string) => `${siteUrl}/r/${name}.json`

/** The environment of a person's shell: ours, less what npm, Playwright and our own packages put into it. */
const someonesShell = Object.fromEntries(
  Object.entries({ ...process.env, CI: '1', NO_COLOR: '1', NEXT_TELEMETRY_DISABLED: '1' })
    .filter(([name]) => !/^(NODE_ENV|FORCE_COLOR|INIT_CWD|SITE_URL)$|^npm_(?!config_registry$)/.test(name))
    .map(([name, value = '']) => [name, name === 'PATH' ? withoutOurTools(value) : value]),
)

function withoutOurTools(path: string) {
  return path
    .split(delimiter)
    .filter((folder) => !folder.endsWith('node_modules/.bin'))
    .join(delimiter)
}

/**
 * ms that a command may take, many times what the longest does: a hang is to fail with the command's name.
 */
const limit = 200_000

export type Outcome = { code: number; output: string }

/** A project of somebody else's, in a folder of its own far from ours, with tools of ours only by name. */
export class Project {
  /** Ends a server each that it has started. */
  readonly stops: (() => Promise<void>)[] = []

  constructor(
    readonly folder: string,
    /** What its commands are to find in their environment. */
    readonly env: Record<string, string> = {},
  ) {}

  /** Puts a folder of tools before those of the machine. */
  finds(tools: string) {
    this.env.PATH = [tools, someonesShell.PATH].join(delimiter)
  }

  path = (...parts: string[]) => join(this.folder, ...parts)
  read = (path: string) => readFile(this.path(path), 'utf8')
  has = (path: string) => existsSync(this.path(path))

  async write(files: Record<string, string | object>) {
    for (const [path, content] of Object.entries(files)) {
      await mkdir(dirname(this.path(path)), { recursive: true })
      await writeFile(
        this.path(path),
        typeof content === 'string' ? content : `${JSON.stringify(content, null, 2)}\n`,
      )
    }
  }

  /** Changes a file by a function of its text. */
  async edit(path: string, change: (text: string) => string) {
    const before = await this.read(path)
    const after = change(before)
    expect(after, `${path} was to change`).not.toBe(before)
    await writeFile(this.path(path), after)
  }

  /** Runs a command in the project and gives its code and all that it said; throws only when it hangs. */
  try(command: string, args: string[] = [], env: Record<string, string> = {}): Promise<Outcome> {
    return new Promise((resolve, reject) => {
      const options = {
        cwd: this.folder,
        maxBuffer: 2 ** 26,
        timeout: limit,
        env: {
          ...someonesShell,
          PWD: this.folder,
          npm_config_prefer_offline: 'true',
          npm_config_audit: 'false',
          npm_config_fund: 'false',
          // ms without a byte before npm asks again, at most three times. Of its own accord it waits 5
          // minutes.
          npm_config_fetch_timeout: '20000',
          npm_config_fetch_retries: '3',
          npm_config_fetch_retry_mintimeout: '1000',
          ...this.env,
          ...env,
        } as Record<string, string> as NodeJS.ProcessEnv,
      }
      const child = execFile(command, args, options, (error, stdout, stderr) => {
        const code = typeof error?.code === 'number' ? error.code : error ? 1 : 0
        const output = `${stdout}${stderr}${error && !child.pid ? error.message : ''}`
        if (error?.killed)
          reject(Error(`${command} ${args.join(' ')} did not end within ${limit / 1000} s\n${output}`))
        else resolve({ code, output })
      })
      child.stdin?.end()
    })
  }

  /** Runs a command that has to end well, and gives what it said. */
  run(command: string, args: string[] = [], env: Record<string, string> = {}): Promise<string> {
    return base.step(`${command} ${args.join(' ')}`, async () => {
      const { code, output } = await this.try(command, args, env)
      expect(code, `${command} ${args.join(' ')}\n${output}`).toBe(0)
      return output
    })
  }

  /** The real shadcn CLI, at the version this repository pins. */
  shadcn = (...args: string[]) => this.run(join(root, 'node_modules/.bin/shadcn'), args)

  /** Starts a server of the project on a free port. Returns its address and a way to end it early. */
  async serve(command: string, args: (port: number) => string[]) {
    const port = await freePort()
    const child = spawn(this.path('node_modules/.bin', command), args(port), {
      cwd: this.folder,
      stdio: 'ignore',
      env: { ...someonesShell, PWD: this.folder } as Record<string, string> as NodeJS.ProcessEnv,
    })
    const stop = async () => {
      if (child.exitCode !== null || child.signalCode !== null) return
      child.kill()
      await once(child, 'exit')
    }
    this.stops.push(stop)
    const url = `http://localhost:${port}`
    await expect
      .poll(() =>
        fetch(url).then(
          (response) => response.ok,
          () => false,
        ),
      )
      .toBe(true)
    return { url, stop }
  }
}

/**
 * `make(name)` gives an empty folder for a project. A test that passes removes it; servers end in any case.
 */
export const test = base.extend<{ make: (name: string) => Promise<Project> }>({
  // biome-ignore lint/correctness/noEmptyPattern: Playwright reads a fixture's needs from this pattern
  make: async ({}, use, info) => {
    const folder = await mkdtemp(join(tmpdir(), 'gravity-stack-'))
    const projects: Project[] = []
    await use(async (name) => {
      const project = new Project(join(folder, name))
      projects.push(project)
      await mkdir(project.folder)
      return project
    })
    await Promise.all(projects.flatMap(({ stops }) => stops).map((stop) => stop()))
    if (info.status === info.expectedStatus) await rm(folder, { recursive: true, force: true })
    else console.log(`Left as it was: ${folder}`)
  },
})

export const tool = (name: string) => join(root, 'node_modules/.bin', name)

/** For the CLI: what it asks of other sites than ours is answered from this checkout. */
export const answered = { NODE_OPTIONS: `--import=${join(root, 'e2e/install/elsewhere.mjs')}` }

/** What `shadcn init` writes, less the base colour, which it would look up on its own site. */
export const components = (css: string, more: object = {}) => ({
  $schema: 'https://ui.shadcn.com/schema.json',
  style: 'new-york',
  rsc: true,
  tsx: true,
  tailwind: { config: '', css, baseColor: '', cssVariables: true },
  aliases: {
    components: '@/components',
    utils: '@/lib/utils',
    ui: '@/components/ui',
    lib: '@/lib',
    hooks: '@/hooks',
  },
  iconLibrary: 'lucide',
  ...more,
})

export const docsPage = (page: string) => readFile(join(root, 'content/docs', `${page}.mdx`), 'utf8')

/** A code block of the docs, by the title it carries or the heading it stands under. */
export async function docsCode(page: string, { title, heading }: { title?: string; heading?: string }) {
  const text = await docsPage(page)
  const section = heading ? text.slice(text.indexOf(`\n## ${heading}\n`)) : text
  const code = section.match(
    title ? RegExp(`\`\`\`\\w+ title="${title}"\\n([\\s\\S]*?)\`\`\``) : /```\w+\n([\s\S]*?)```/,
  )
  if (!code) throw new Error(`${page} has no code block ${title ?? heading}`)
  return code[1]
}

type Starter = { template?: string; starter?: string[]; install?: string[]; tailwind?: boolean }

/** A project from Vite's own starter, with Tailwind and the `@/` alias set up as the Setup page says. */
export async function viteProject(project: Project, options: Starter = {}) {
  const { template = 'react-ts', starter = [], install = ['npm', 'install'], tailwind = true } = options
  await project.run(tool('create-vite'), ['.', '--template', template, ...starter, '--no-interactive'])
  const alias = JSON.parse(await docsCode('setup', { title: 'tsconfig.json' })).compilerOptions.paths
  const paths = `"compilerOptions": { "paths": ${JSON.stringify(alias)}`
  await project.edit('tsconfig.json', (text) => text.replace('{', `{ ${paths} },`))
  await project.edit('tsconfig.app.json', (text) => text.replace('"compilerOptions": {', `${paths},`))
  // The starter's own plugins stay; the alias and Tailwind's plugin come as on the page.
  const told = await docsCode('setup', { title: 'vite.config.ts' })
  const lines = (pattern: RegExp) => told.match(pattern)?.join('\n') ?? ''
  await project.edit('vite.config.ts', (text) =>
    `${lines(/^import .*node:url.*$/m)}\n${text}`.replace(
      'defineConfig({',
      `defineConfig({\n${lines(/^ *resolve: .*$/m)}`,
    ),
  )
  await project.write({ 'components.json': components('src/index.css', { rsc: false }) })
  const [command, ...args] = install
  if (!tailwind) return project.run(command, args)
  await project.edit('vite.config.ts', (text) =>
    `${lines(/^import .*tailwindcss\/vite.*$/m)}\n${text}`.replace('plugins: [', 'plugins: [tailwindcss(), '),
  )
  await project.write({ 'src/index.css': await docsCode('setup', { title: 'src/index.css' }) })
  await project.run(command, [...args, 'tailwindcss', '@tailwindcss/vite'])
}

/** A project fresh from Next's own starter. Its fonts come from the network, so they stay out. */
export async function nextProject(project: Project, ...options: string[]) {
  await project.run(tool('create-next-app'), [
    '.',
    ...['--typescript', '--tailwind', '--app', '--no-src-dir', '--import-alias', '@/*'],
    ...['--skip-install', '--disable-git', '--yes', '--no-agents-md'],
    ...options,
  ])
  await project.write({
    'app/layout.tsx': `import './globals.css'

export default function RootLayout({ children }: { children: React.ReactNode }) {
  return (
    <html lang="en">
      <body>{children}</body>
    </html>
  )
}
`,
    'components.json': components('app/globals.css'),
  })
}

const box = '[data-slot="gravity-stack"]'

/** On a consumer's page: the pile falls and rests in its stage, a chip is dragged, and all rests again. */
export async function expectPile(page: Page, url: string) {
  const errors: string[] = []
  page.on('pageerror', (error) => errors.push(error.message))
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()))

  await page.goto(url)
  const stage = page.locator(box)
  await expect(stage).toHaveAttribute('data-state', 'resting')

  const chips = stage.locator('[data-slot="gravity-stack-chip"]')
  const area = await boxOf(stage)
  for (const chip of await chips.all()) {
    const { left, right, bottom } = await outlineOf(chip)
    expect(left).toBeGreaterThan(area.left - 1)
    expect(right).toBeLessThan(area.right + 1)
    expect(bottom).toBeLessThan(area.bottom + 1)
  }

  const highest = await topmost(chips)
  const before = await boxOf(highest)
  const x = (before.left + before.right) / 2
  const y = (before.top + before.bottom) / 2
  await page.mouse.move(x, y)
  await page.mouse.down()
  const aside = x < (area.left + area.right) / 2 ? area.right - 120 : area.left + 120
  await page.mouse.move(aside, area.top + 60, { steps: 10 })
  await expect(highest).toHaveAttribute('data-state', 'held')
  await expect(stage).toHaveAttribute('data-state', 'running')
  await page.mouse.up()
  await expect(stage).toHaveAttribute('data-state', 'resting')
  const after = await boxOf(highest)
  expect(Math.abs(after.left - before.left), 'the dragged chip lies somewhere else').toBeGreaterThan(20)
  expect(errors).toEqual([])
}

type Chips = ReturnType<Page['locator']>

const boxOf = (chip: Chips) =>
  chip.evaluate((element) => {
    const { left, right, top, bottom } = element.getBoundingClientRect()
    return { left, right, top, bottom }
  })

/** The box around what is drawn of a turned chip: a rectangle's corners reach farther than round ones. */
const outlineOf = (chip: Chips) =>
  chip.evaluate((element) => {
    const box = element.getBoundingClientRect()
    const { offsetWidth: width, offsetHeight: height } = element as HTMLElement
    const { a, b } = new DOMMatrix(getComputedStyle(element).transform)
    const corner = Number.parseFloat(getComputedStyle(element.firstElementChild ?? element).borderRadius) || 0
    const radius = Math.min(corner, width / 2, height / 2)
    const [cos, sin] = [Math.abs(a), Math.abs(b)]
    const reachX = (width / 2 - radius) * cos + (height / 2 - radius) * sin + radius
    const reachY = (width / 2 - radius) * sin + (height / 2 - radius) * cos + radius
    const x = (box.left + box.right) / 2
    return { left: x - reachX, right: x + reachX, bottom: (box.top + box.bottom) / 2 + reachY }
  })

async function topmost(chips: Chips) {
  const tops = await Promise.all((await chips.all()).map((chip) => boxOf(chip)))
  return chips.nth(tops.reduce((best, { top }, index) => (top < tops[best].top ? index : best), 0))
}

export { expect }
