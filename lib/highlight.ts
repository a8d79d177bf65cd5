import 'server-only'
import { createHighlighter } from 'shiki'
import { codeTheme } from './code-theme'

const highlighter = createHighlighter({ themes: [codeTheme], langs: ['tsx', 'bash', 'json', 'css'] })

export type CodeLanguage = 'tsx' | 'bash' | 'json' | 'css'

/** Code in, the HTML of a `<pre>` out. Runs at build time only. */
export async function highlight(code: string, lang: CodeLanguage = 'tsx'): Promise<string> {
  const html = (await highlighter).codeToHtml(code.trimEnd(), { lang, theme: codeTheme })
  // The theme's own background would hide the box that the code stands in.
  return html.replace(/<pre class="[^"]*" style="[^"]*"/, '<pre')
}
