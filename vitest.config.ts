import { fileURLToPath } from 'node:url'
import { configDefaults, defineConfig } from 'vitest/config'
import { BaseSequencer, type TestSpecification } from 'vitest/node'

/** The file that takes longest is a short one, which Vitest would begin last and wait for alone. */
class HardScenesFirst extends BaseSequencer {
  override async sort(files: TestSpecification[]) {
    const later = ({ moduleId }: TestSpecification) => (moduleId.endsWith('/stability.test.ts') ? 0 : 1)
    return (await super.sort(files)).sort((a, b) => later(a) - later(b))
  }
}

export default defineConfig({
  resolve: { alias: { '@': fileURLToPath(new URL('.', import.meta.url)).replace(/\/$/, '') } },
  test: {
    include: ['**/*.test.{ts,tsx}'],
    // More than twice what the longest takes on a busy machine: limits are for what hangs.
    testTimeout: 180_000,
    maxWorkers: 2,
    sequence: { sequencer: HardScenesFirst },
    exclude: [...configDefaults.exclude, 'out/**', '.next/**', 'e2e/**'],
  },
})
