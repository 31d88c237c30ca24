import { writeFileSync } from 'node:fs';
import { PhysicsError } from '@principia/physics';
import { ArgumentError, helpText, type RunRequest, readArguments, sceneList } from './arguments.ts';
import { reportHtml } from './report-html.ts';
import { resultTable } from './report-table.ts';
import { runBench } from './run-bench.ts';

try {
  const request = readArguments(process.argv.slice(2));
  if (request.kind === 'help') print(helpText());
  else if (request.kind === 'list') print(sceneList());
  else await measure(request);
} catch (error) {
  if (!(error instanceof ArgumentError || error instanceof PhysicsError)) throw error;
  process.stderr.write(`${error.message}\n`);
  process.exitCode = error instanceof ArgumentError ? 2 : 1;
}

async function measure(request: RunRequest): Promise<void> {
  const outcome = await runBench(request);
  print(resultTable(outcome.result));
  if (request.json !== undefined) writeFileSync(request.json, `${JSON.stringify(outcome.result, null, 2)}\n`);
  if (request.html !== undefined) writeFileSync(request.html, reportHtml(outcome, request.scene));
}

function print(text: string): void {
  process.stdout.write(`${text}\n`);
}
