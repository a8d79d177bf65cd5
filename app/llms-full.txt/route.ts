import { twins } from '@/lib/markdown'
import { componentFile, componentSource } from '@/lib/source'

export const dynamic = 'force-static'

export function GET() {
  const source = `# ${componentFile}\n\n\`\`\`tsx\n${componentSource()}\`\`\`\n`
  return new Response([...Object.values(twins).map((twin) => twin()), source].join('\n'))
}
