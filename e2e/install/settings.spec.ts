import { components, docsCode, expect, expectPile, item, type Project, test, viteProject } from './project'

const usage = async (project: Project) =>
  project.write({
    'src/topics.tsx': await docsCode('gravity-stack', { heading: 'Usage' }),
    'src/App.tsx': "export { Topics as default } from '@/topics'\n",
  })

test('a project with the strictest TypeScript, React Compiler and ESLint takes the file as it is', async ({
  make,
  page,
}) => {
  const project = await make('strict')
  await viteProject(project, {
    template: 'react-compiler-ts',
    starter: ['--eslint'],
    // The starter's own TypeScript is newer than its ESLint rules can read.
    install: ['npm', 'install', 'typescript@5.9'],
  })
  await project.edit('tsconfig.app.json', (text) =>
    text.replace(
      '"skipLibCheck": true,',
      `"skipLibCheck": true,
      "strict": true, "exactOptionalPropertyTypes": true, "noUncheckedIndexedAccess": true,
      "noImplicitOverride": true, "noImplicitReturns": true, "noPropertyAccessFromIndexSignature": true,
      "isolatedModules": true,`,
    ),
  )
  expect(await project.read('tsconfig.app.json')).toContain('"verbatimModuleSyntax": true')
  await project.shadcn('add', item('gravity-stack'), '--yes')
  await usage(project)
  await project.run('npm', ['run', 'build'])
  await project.run('npx', ['eslint', 'src/components', 'src/topics.tsx'])
  const server = await project.serve('vite', (port) => ['preview', '--port', `${port}`, '--strictPort'])
  await expectPile(page, server.url)
  await server.stop()
})

test('a project whose Tailwind has a prefix, read from right to left, shows the pile', async ({
  make,
  page,
}) => {
  const project = await make('prefixed')
  await viteProject(project)
  const css = await project.read('src/index.css')
  await project.write({
    'src/index.css': css.replace('"tailwindcss"', '"tailwindcss" prefix(tw)'),
    'components.json': {
      ...components('src/index.css', { rsc: false, rtl: true }),
      tailwind: { config: '', css: 'src/index.css', baseColor: '', cssVariables: true, prefix: 'tw' },
    },
  })
  await project.edit('index.html', (text) => text.replace('<html', '<html dir="rtl"'))
  await project.shadcn('add', item('gravity-stack'), '--yes')
  const added = await project.read('src/components/ui/gravity-stack.tsx')
  for (const name of ['absolute', 'relative', 'h-80', 'cursor-grab'])
    expect(added).toMatch(RegExp(`['" ]tw:${name}['" ]`))
  await usage(project)
  await project.edit('src/topics.tsx', (text) =>
    text.replace(
      /className="([^"]+)"/g,
      (_, names: string) => `className="${names.replace(/\S+/g, 'tw:$&')}"`,
    ),
  )
  await project.run('npm', ['run', 'build'])
  const server = await project.serve('vite', (port) => ['preview', '--port', `${port}`, '--strictPort'])
  await expectPile(page, server.url)
  await server.stop()
})

test('a project as shadcn made them in 2024 compiles and shows the pile, with no hand work', async ({
  make,
  page,
}) => {
  const project = await make('older')
  await project.write({
    'package.json': {
      name: 'older',
      private: true,
      type: 'module',
      scripts: { build: 'tsc && vite build' },
      dependencies: {
        'class-variance-authority': '^0.7.0',
        clsx: '^2.1.1',
        react: '^18.3.1',
        'react-dom': '^18.3.1',
        'tailwind-merge': '^2.5.4',
        'tailwindcss-animate': '^1.0.7',
      },
      devDependencies: {
        '@types/react': '^18.3.12',
        '@types/react-dom': '^18.3.1',
        '@vitejs/plugin-react': '^4.3.3',
        autoprefixer: '^10.4.20',
        postcss: '^8.4.49',
        tailwindcss: '^3.4.15',
        typescript: '~5.6.2',
        vite: '^5.4.11',
      },
    },
    'tsconfig.json': {
      compilerOptions: {
        target: 'ES2020',
        lib: ['ES2020', 'DOM', 'DOM.Iterable'],
        module: 'ESNext',
        moduleResolution: 'bundler',
        isolatedModules: true,
        noEmit: true,
        jsx: 'react-jsx',
        skipLibCheck: true,
        strict: true,
        noUnusedLocals: true,
        noUnusedParameters: true,
        baseUrl: '.',
        paths: { '@/*': ['./src/*'] },
      },
      include: ['src'],
    },
    'vite.config.js': `import react from '@vitejs/plugin-react'
import path from 'node:path'
export default { plugins: [react()], resolve: { alias: { '@': path.resolve('./src') } } }
`,
    'postcss.config.js': 'export default { plugins: { tailwindcss: {}, autoprefixer: {} } }\n',
    'tailwind.config.js': `import animate from 'tailwindcss-animate'
export default {
  darkMode: ['class'],
  content: ['./index.html', './src/**/*.{ts,tsx}'],
  theme: { extend: { borderRadius: { lg: 'var(--radius)' } } },
  plugins: [animate],
}
`,
    'components.json': {
      $schema: 'https://ui.shadcn.com/schema.json',
      style: 'new-york',
      rsc: false,
      tsx: true,
      tailwind: {
        config: 'tailwind.config.js',
        css: 'src/index.css',
        baseColor: '',
        cssVariables: true,
        prefix: '',
      },
      aliases: {
        components: '@/components',
        utils: '@/lib/utils',
        ui: '@/components/ui',
        lib: '@/lib',
        hooks: '@/hooks',
      },
    },
    'src/index.css': `@tailwind base;
@tailwind components;
@tailwind utilities;
@layer base {
  :root { --background: 0 0% 100%; --radius: 0.5rem; }
}
`,
    'src/lib/utils.ts': `import { clsx, type ClassValue } from 'clsx'
import { twMerge } from 'tailwind-merge'

export function cn(...inputs: ClassValue[]) {
  return twMerge(clsx(inputs))
}
`,
    'index.html':
      '<!doctype html><link rel="icon" href="data:,"><div id="root"></div><script type="module" src="/src/main.tsx"></script>\n',
    'src/vite-env.d.ts': '/// <reference types="vite/client" />\n',
    'src/main.tsx': `import { createRoot } from 'react-dom/client'
import App from './App'
import './index.css'
createRoot(document.getElementById('root')!).render(<App />)
`,
  })
  await project.run('npm', ['install'])
  const utils = await project.read('src/lib/utils.ts')
  await project.shadcn('add', item('gravity-stack'), '--yes')
  await usage(project)
  await project.run('npm', ['run', 'build'])
  expect(await project.read('src/lib/utils.ts'), "the owner's own cn is left alone").toBe(utils)
  const server = await project.serve('vite', (port) => ['preview', '--port', `${port}`, '--strictPort'])
  await expectPile(page, server.url)
  await server.stop()
})
