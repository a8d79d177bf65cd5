import { twins } from '@/lib/markdown'
import { componentFile, componentSource } from '@/lib/source'

export const dynamic = 'force-static'

export async function GET() {
  const source = `# ${componentFile}\n\n\`\`\`tsx\n${componentSource()}\`\`\`\n`
  const pages = await Promise.all(Object.values(twins).map((twin) => twin()))
  return new Response([...pages, source].join('\n'))
}
