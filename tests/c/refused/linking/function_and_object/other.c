int turn = 3;  // error: it is also defined at
