-- What the PDF needs beyond pandoc's own LaTeX: pictures as PDF, a new page for each chapter, places to break long names
-- in tables, sketches in a size that fits.

local function latex_inline(text) return pandoc.RawInline('latex', text) end
local function latex_block(text) return pandoc.RawBlock('latex', text) end

function Image(image)
  image.src = image.src:gsub('%.svg$', '.pdf')
  return image
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

function Table(wide)
  return pandoc.walk_block(wide, { Str = function(word) return breakable(word.text) end })
end

-- 100 columns of \footnotesize fill the page.
function CodeBlock(block)
  local longest = 0
  for line in block.text:gmatch('[^\n]+') do
    longest = math.max(longest, utf8.len(line) or #line)
  end
  local size = longest <= 84 and '\\small' or longest <= 100 and '\\footnotesize' or longest <= 118 and '\\scriptsize' or '\\tiny'
  return { latex_block('\\begingroup' .. size), block, latex_block('\\endgroup') }
end
