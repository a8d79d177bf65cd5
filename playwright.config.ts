import { existsSync } from 'node:fs'
import { defineConfig } from '@playwright/test'
import { findBrowser } from './scripts/browser.mjs'
import { siteUrl } from './site.config.mjs'

const fixturesUrl = 'http://localhost:4310'
const reuseExistingServer = !process.env.CI

export default defineConfig({
  testDir: 'e2e',
  fullyParallel: true,
  // On two cores: half the time a pile only takes its time.
  workers: 4,
  forbidOnly: true,
  // More than twice what the longest takes here: limits are for what hangs, not for a busy machine.
  timeout: 180_000,
  // A pile takes seconds to lie still, and a busy machine several times as many.
  expect: { timeout: 60_000 },
  use: {
    baseURL: siteUrl,
    launchOptions: { executablePath: findBrowser()?.path },
  },
  projects: [
    { name: 'component', testMatch: 'component-*.spec.ts', use: { baseURL: fixturesUrl } },
    { name: 'site', testIgnore: ['component-*.spec.ts', 'install/*.spec.ts'] },
    { name: 'install', testMatch: 'install/*.spec.ts', timeout: 300_000 },
  ],
  webServer: [
    { command: 'node e2e/fixtures/server.mjs', url: fixturesUrl, reuseExistingServer },
    // The component's own tests need no built site.
    ...(existsSync('out') ? [{ command: 'node scripts/serve.mjs', url: siteUrl, reuseExistingServer }] : []),
  ],
})
