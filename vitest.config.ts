import { fileURLToPath } from 'node:url'
import { configDefaults, defineConfig } from 'vitest/config'

export default defineConfig({
  resolve: { alias: { '@': fileURLToPath(new URL('.', import.meta.url)).replace(/\/$/, '') } },
  test: {
    include: ['**/*.test.{ts,tsx}'],
    testTimeout: 60_000,
    maxWorkers: 2,
    exclude: [...configDefaults.exclude, 'out/**', '.next/**', 'e2e/**'],
  },
})
