import { readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'

/**
 * Next's `async` scripts share the line with the fonts, and on a quick line they are compiled and run before
 * the first paint, which waits for them. The pages of `folder` ask for them when their words can be read.
 */
export function lateScripts(folder) {
  for (const file of readdirSync(folder, { recursive: true })) {
    if (!file.endsWith('.html')) continue
    const path = join(folder, file)
    const scripts = []
    const html = readFileSync(path, 'utf8')
      .replaceAll(/<link rel="preload" as="script"[^>]*>/g, '')
      .replaceAll(/<script src="([^"]+)"(?: id="[^"]*")? async=""><\/script>/g, (_, src) => {
        scripts.push(src)
        return ''
      })
    if (scripts.length === 0) throw new Error(`${path} has no scripts as Next used to write them`)
    const end = '</body></html>'
    if (!html.endsWith(end)) throw new Error(`${path} does not end as Next used to end it`)
    writeFileSync(path, `${html.slice(0, -end.length)}<script>${loader(scripts)}</script>${end}`)
  }
}

// Next waits for the scripts of __next_s before it starts the page. The empty one there parts React's setup
// (instrumentation-client.ts) from that start: one task of 40 ms becomes two of 20. A timer would stop with a
// page's clock.
// Words wait for their font, so the first paint may be bare. A hidden tab paints nothing. Some browsers don't
// tell when they paint: for them there is the timer.
const loader = (scripts) =>
  `{self.__next_s=[["data:text/javascript,"]];let asked,ask=()=>{if(asked)return;asked=1;for(let src of ${JSON.stringify(scripts)})document.head.append(Object.assign(document.createElement("script"),{src,async:!0}))};document.hidden?ask():(new PerformanceObserver(seen=>seen.getEntriesByName("first-contentful-paint")[0]&&ask()).observe({type:"paint",buffered:!0}),setTimeout(ask,3e3))}`
