-- What the PDF needs beyond pandoc's own LaTeX: pictures as PDF, a new page for each chapter, places to break long names
-- in tables, sketches in a size that fits.

local function latex_inline(text) return pandoc.RawInline('latex', text) end
local function latex_block(text) return pandoc.RawBlock('latex', text) end

function Image(image)
  image.src = image.src:gsub('%.svg$', '.pdf')
  return image
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

-- A formula between two paragraphs belongs to the one before: as one of its own it would begin with an empty line.
function Blocks(blocks)
  local joined = pandoc.List()
  for _, block in ipairs(blocks) do
    local last = joined[#joined]
    local formula = block.t == 'Para' and block.content[1].t == 'Math' and block.content[1].mathtype == 'DisplayMath'
    if formula and last and last.t == 'Para' then
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
function Header(header)
  if header.level > 1 then return { latex_block('\\TalusRoom'), header } end
  chapters = chapters + 1
  local title = pandoc.utils.stringify(header)
  local shares = { Errata = true, ['Appendix: provenance'] = true, References = true, Colophon = true }
  if chapters == 1 or shares[title] then return nil end
  if chapters == 2 then  -- the contents share its page
    return { latex_block('\\clearpage\\setcounter{tocdepth}{1}\\begingroup\\small\\tableofcontents\\endgroup\\bigskip'), header }
  end
  return { latex_block('\\clearpage'), header }
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

-- What is seen of a cell, in letters; of a formula about as many as its signs without commands and braces.
local function length_of(blocks)
  local letters = 0
  pandoc.walk_block(pandoc.Div(blocks), {
    Str = function(word) letters = letters + utf8.len(word.text) end,
    Code = function(code) letters = letters + utf8.len(code.text) end,
    Space = function() letters = letters + 1 end,
    SoftBreak = function() letters = letters + 1 end,
    Math = function(formula) letters = letters + #formula.text:gsub('\\%a+', 'x'):gsub('[{}^_ ]', '') end,
  })
  return letters
end

-- Where all has room, columns are as wide as what they hold; pandoc would spread them over the page, and break cells.
local function fit_columns(wide)
  local longest = {}
  for i = 1, #wide.colspecs do longest[i] = 3 end
  local function measure(rows)
    for _, row in ipairs(rows) do
      for i, cell in ipairs(row[2] or row.cells) do
        longest[i] = math.max(longest[i], length_of(cell.contents) + 2)
      end
    end
  end
  measure(wide.head[2] or wide.head.rows)
  for _, body in ipairs(wide.bodies) do measure(body.body) end
  local sum = 0
  for _, letters in ipairs(longest) do sum = sum + letters end
  if sum > 110 then return end
  for i, spec in ipairs(wide.colspecs) do wide.colspecs[i] = { spec[1], nil } end
end

function Table(wide)
  fit_columns(wide)
  return pandoc.walk_block(wide, { Str = function(word) return breakable(word.text) end })
end

-- 100 columns of \footnotesize fill the page; sketches are small already.
function CodeBlock(block)
  local longest = 0
  for line in block.text:gmatch('[^\n]+') do
    longest = math.max(longest, utf8.len(line) or #line)
  end
  local size = longest <= 100 and '\\footnotesize' or longest <= 118 and '\\scriptsize' or '\\tiny'
  return { latex_block('\\begingroup' .. size), block, latex_block('\\endgroup') }
end
