"""The command line: distances, fields, matrices and samplings of mesh files, one by one or by the folder."""
