import { defineConfig } from '@playwright/test'
import { findBrowser } from './scripts/browser.mjs'

const port = 4173

export default defineConfig({
  testDir: 'e2e',
  fullyParallel: true,
  workers: 2,
  forbidOnly: true,
  timeout: 60_000,
  use: {
    baseURL: `http://localhost:${port}`,
    launchOptions: { executablePath: findBrowser()?.path },
    trace: 'retain-on-failure',
  },
  projects: [
    { name: 'component', testMatch: /e2e\/(?!site)[^/]*\.spec\.ts$/ },
    { name: 'site', testMatch: /e2e\/site[^/]*\.spec\.ts$/ },
    { name: 'install', testMatch: /e2e\/install\/[^/]*\.spec\.ts$/, timeout: 300_000 },
  ],
  webServer: {
    command: 'node scripts/serve.mjs',
    env: { PORT: String(port) },
    url: `http://localhost:${port}`,
  },
})
