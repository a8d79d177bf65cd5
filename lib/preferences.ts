/**
 * Choices that outlive a visit: the theme, the package manager, the way to install. They stand on <html> as
 * attributes, so that CSS can show the right thing before React has loaded, and in localStorage under the
 * same names.
 */
export const choices = {
  'package-manager': ['npm', 'pnpm', 'yarn', 'bun'],
  install: ['cli', 'manual', 'prompt'],
} as const

export type Choice = keyof typeof choices

/** The page's ground in either theme, for what a browser draws around it. */
export const grounds = { light: '#fcfbf9', dark: '#0f0e0d' }

/**
 * Runs in <head> before the first paint, and again when a page comes back as it was left or another tab has
 * saved something. Storage throws where cookies are blocked.
 */
export const preferencesScript = `(() => {
  const root = document.documentElement
  const saved = (key) => { try { return localStorage.getItem(key) } catch { return null } }
  const apply = () => {
    const theme = saved('theme')
    if (theme) root.classList.toggle('dark', theme === 'dark')
    for (const [key, options] of Object.entries(${/* @__PURE__ */ JSON.stringify(choices)})) {
      const choice = saved(key)
      if (options.includes(choice)) root.setAttribute('data-' + key, choice)
    }
  }
  root.classList.toggle('dark', matchMedia('(prefers-color-scheme: dark)').matches)
  apply()
  // The page's own colours for the bar go by the system; the first that holds counts.
  const bar = Object.assign(document.createElement('meta'), { name: 'theme-color' })
  const paint = () => { bar.content = root.classList.contains('dark') ? '${grounds.dark}' : '${grounds.light}' }
  paint()
  document.head.prepend(bar)
  new MutationObserver(paint).observe(root, { attributeFilter: ['class'] })
  addEventListener('pageshow', (event) => event.persisted && apply())
  addEventListener('storage', apply)
})()`

export function save(key: string, value: string) {
  try {
    localStorage.setItem(key, value)
  } catch {
    // The choice then lasts as long as the page.
  }
}
