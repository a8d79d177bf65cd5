import { createCssVariablesTheme } from 'shiki'

/** Code takes its colours from `--code-*` in app/globals.css, so that one HTML serves both themes. */
export const codeTheme = createCssVariablesTheme({ name: 'gravity-stack', variablePrefix: '--code-' })
