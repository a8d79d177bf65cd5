import { existsSync } from 'node:fs'
import { defineConfig } from '@playwright/test'
import { findBrowser } from './scripts/browser.mjs'
import { siteUrl } from './site.config.mjs'

export default defineConfig({
  testDir: 'e2e',
  fullyParallel: true,
  workers: 2,
  forbidOnly: true,
  timeout: 60_000,
  use: {
    baseURL: siteUrl,
    launchOptions: { executablePath: findBrowser()?.path },
    trace: 'retain-on-failure',
  },
  projects: [
    { name: 'component', testMatch: /e2e\/(?!site)[^/]*\.spec\.ts$/ },
    { name: 'site', testMatch: /e2e\/site[^/]*\.spec\.ts$/ },
    { name: 'install', testMatch: /e2e\/install\/[^/]*\.spec\.ts$/, timeout: 300_000 },
  ],
  // The component's own tests need no built site.
  webServer: existsSync('out')
    ? { command: 'node scripts/serve.mjs', url: siteUrl, reuseExistingServer: !process.env.CI }
    : undefined,
})
