int turn = 3;  // error: also defined at
