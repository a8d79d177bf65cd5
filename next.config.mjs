/** @type {import('next').NextConfig} */
export default {
  output: 'export',
  reactStrictMode: true,
  serverExternalPackages: ['esbuild', 'react-docgen', 'shiki'],
  // This folder is the root, also when a folder above holds a lock file.
  turbopack: { root: import.meta.dirname },
}
