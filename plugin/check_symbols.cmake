# Fails if a plugin leaves symbols of our own undefined: the linker allows undefined ones because the host has many.
# In: NM, FILE.
execute_process(COMMAND ${NM} -D --undefined-only ${FILE} OUTPUT_VARIABLE undefined COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "_Z[A-Za-z0-9_]*7vorogeo[A-Za-z0-9_]*" ours "${undefined}")
if(ours)
  list(JOIN ours "\n  " ours)
  message(FATAL_ERROR "${FILE} uses functions that are declared but defined nowhere:\n  ${ours}")
endif()
