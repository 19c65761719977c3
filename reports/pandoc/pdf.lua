-- What the PDF needs beyond pandoc's own LaTeX: pictures as PDF, a new page for each chapter, places to break long names
-- in tables, sketches in the size in which they are drawn.

local function latex_inline(text) return pandoc.RawInline('latex', text) end
local function latex_block(text) return pandoc.RawBlock('latex', text) end

function Image(image)
  image.src = image.src:gsub('%.svg$', '.pdf')
  if image.classes:includes('sketch') then  -- 4 em in the site are a centimetre on paper
    image.attributes.width = ('%.2fcm'):format(tonumber(image.attributes.width:match('[%d.]+')) / 4)
  end
  return image
end

-- Links between the volumes lead from PDF to PDF. The numbers of a figure are beside the site, not beside the PDF.
function Link(link)
  if link.target:match('^data/') then return {} end
  link.target = link.target:gsub('^(verification[%w-]*)%.md#.*$', '%1.pdf')
  return link
end

-- A figure beside its caption.
function Para(paragraph)
  local image = paragraph.content[1]
  if #paragraph.content ~= 1 or image.t ~= 'Image' or not image.classes:includes('beside') then return nil end
  local share = tonumber(image.attributes.width:match('[%d.]+')) / 100
  local inlines = pandoc.List({ latex_inline(('\\TalusBeside{%.3f}{%s}{'):format(share, image.src)) })
  inlines:extend(image.caption)
  inlines:insert(latex_inline('}'))
  return pandoc.Para(inlines)
end

-- A formula between two paragraphs belongs to the one before: as a separate one it would begin with an empty line.
function Blocks(blocks)
  local joined = pandoc.List()
  for _, block in ipairs(blocks) do
    local last = joined[#joined]
    local first = last and last.t == 'Para' and block.t == 'Para' and block.content[1]
    if first and first.t == 'Math' and first.mathtype == 'DisplayMath' then
      last.content:insert(pandoc.SoftBreak())
      last.content:extend(block.content)
    else
      joined:insert(block)
    end
  end
  return joined
end

-- The first chapter is the front page and its title; some share a page with the one before.
local chapters = 0
local depth = PANDOC_STATE.output_file:match('details') and 2 or 1  -- of the contents
function Header(header)
  local name = pandoc.utils.stringify(header)
  if header.level == 2 and chapters == 1 and name == 'Findings' then
    return { latex_block('\\clearpage'), header }
  end
  if header.level > 1 then return { latex_block('\\TalusRoom'), header } end
  chapters = chapters + 1
  local title = pandoc.utils.stringify(header)
  local shares = { Errata = true, Provenance = true, References = true, Colophon = true }
  if chapters == 1 or shares[title] then return nil end
  if chapters == 2 then  -- the contents share its page
    return { latex_block('\\clearpage\\setcounter{tocdepth}{' .. depth .. '}\\begingroup\\small\\tableofcontents\\endgroup\\bigskip'), header }
  end
  return { latex_block('\\TalusChapter'), header }
end

-- A long word may break after a comma or a semicolon; names and numbers stay whole.
local function breakable(word)
  if #word < 12 or tonumber(word) then return nil end
  local parts = {}
  for head in word:gmatch('[^,;]*[,;]?') do
    if head ~= '' then
      parts[#parts + 1] = pandoc.Str(head)
      parts[#parts + 1] = latex_inline('\\allowbreak{}')
    end
  end
  return parts
end

-- What is seen of a cell, in letters; of a formula about as many as its signs without commands and braces. By hand:
-- pandoc.walk_block takes twice as long as all the rest of this file.
local function length_of(elements)
  local letters = 0
  for _, element in ipairs(elements) do
    local kind = element.t
    if kind == 'Str' or kind == 'Code' then
      letters = letters + utf8.len(element.text)
    elseif kind == 'Space' or kind == 'SoftBreak' then
      letters = letters + 1
    elseif kind == 'Math' then
      letters = letters + #element.text:gsub('\\%a+', 'x'):gsub('[{}^_ ]', '')
    elseif element.content then
      letters = letters + length_of(element.content)
    end
  end
  return letters
end

-- Where all has room, columns are as wide as what they hold; pandoc would spread them over the page, and break cells.
local function fit_columns(wide)
  local room = 110
  local longest = {}
  for i = 1, #wide.colspecs do longest[i] = 3 end
  local sum = 3 * #longest
  local function measure(rows)
    for _, row in ipairs(rows) do
      for i, cell in ipairs(row[2] or row.cells) do
        local letters = length_of(cell.contents) + 2
        if letters > longest[i] then
          sum = sum + letters - longest[i]
          longest[i] = letters
          if sum > room then return end
        end
      end
    end
  end
  measure(wide.head[2] or wide.head.rows)
  for _, body in ipairs(wide.bodies) do
    if sum <= room then measure(body.body) end
  end
  if sum > room then return end
  for i, spec in ipairs(wide.colspecs) do wide.colspecs[i] = { spec[1], nil } end
end

function Table(wide)
  fit_columns(wide)
  return pandoc.walk_block(wide, { Str = function(word) return breakable(word.text) end })
end

-- 100 columns of \footnotesize fill the page.
function CodeBlock(block)
  local longest = 0
  for line in block.text:gmatch('[^\n]+') do
    longest = math.max(longest, utf8.len(line) or #line)
  end
  local size = longest <= 100 and '\\footnotesize' or longest <= 118 and '\\scriptsize' or '\\tiny'
  return { latex_block('\\begingroup' .. size), block, latex_block('\\endgroup') }
end
